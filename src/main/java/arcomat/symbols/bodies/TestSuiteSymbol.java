package arcomat.symbols.bodies;

import arcomat.symbols.expressions.ExpressionTyping;
import arcomat.symbols.expressions.ParameterSymbol;
import arcomat.symbols.expressions.Typed;
import arcomat.symbols.expressions.ValueScope;
import arcomat.symbols.names.ComponentDeclaration;
import arcomat.symbols.names.Lazy;
import arcomat.symbols.names.Resolution;
import arcomat.symbols.names.TypeSymbol;
import arcomat.symbols.names.UnitScope;
import arcomat.symbols.names.UnknownType;
import arcomat.tree.TestSuite;
import arcomat.tree.Unit;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;

/** A suite of stream tests with the component it is for. */
public final class TestSuiteSymbol {
    private final UnitScope scope;
    private final TestSuite node;
    private final Lazy<Resolution<ComponentSymbol>> component;
    private final Lazy<List<StreamTestSymbol>> tests = new Lazy<>(this::makeTests);

    /**
     * @param components from signatures of components to their symbols
     */
    public TestSuiteSymbol(
            UnitScope scope,
            TestSuite node,
            Function<ComponentDeclaration, ComponentSymbol> components) {
        this.scope = scope;
        this.node = node;
        this.component = new Lazy<>(() -> scope.component(node.component()).map(components));
    }

    public TestSuite node() {
        return node;
    }

    public Unit unit() {
        return scope.unit();
    }

    public String name() {
        return node.name().text();
    }

    /** The component under test. */
    public Resolution<ComponentSymbol> component() {
        return component.get();
    }

    /** The arguments for the component, typed against its parameters. */
    public List<Typed> arguments() {
        List<ParameterSymbol> parameters =
                component().found().map(ComponentSymbol::parameters).orElse(List.of());
        List<Typed> typed = new ArrayList<>();
        for (int i = 0; i < node.arguments().size(); i++) {
            TypeSymbol expected =
                    i < parameters.size() ? parameters.get(i).type() : UnknownType.UNKNOWN;
            typed.add(ExpressionTyping.message(node.arguments().get(i), emptyScope(), expected));
        }
        return typed;
    }

    public List<StreamTestSymbol> tests() {
        return tests.get();
    }

    ValueScope emptyScope() {
        return ValueScope.empty(scope, scope::type);
    }

    private List<StreamTestSymbol> makeTests() {
        return node.members().stream()
                .filter(TestSuite.Test.class::isInstance)
                .map(member -> new StreamTestSymbol(this, (TestSuite.Test) member))
                .toList();
    }
}
