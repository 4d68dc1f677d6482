package arcomat.symbols.bodies;

import arcomat.symbols.expressions.ExpressionTyping;
import arcomat.symbols.expressions.GivenArgument;
import arcomat.symbols.expressions.ValueScope;
import arcomat.symbols.expressions.VariableSymbol;
import arcomat.symbols.names.ComponentDeclaration;
import arcomat.symbols.names.EnumSymbol;
import arcomat.symbols.names.FeatureChoice;
import arcomat.symbols.names.Lazy;
import arcomat.symbols.names.Resolution;
import arcomat.symbols.names.TypeSymbol;
import arcomat.symbols.names.UnitScope;
import arcomat.tree.TestSuite;
import arcomat.tree.Unit;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;

/** A suite of stream tests with the component it is for. */
public final class TestSuiteSymbol {
    private final UnitScope scope;
    private final TestSuite node;
    private final Lazy<Resolution<ComponentSymbol>> component;
    private final Lazy<List<VariableSymbol>> fields;
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
        this.fields = new Lazy<>(() -> new SuiteFields(node, emptyScope()).known());
        this.component =
                new Lazy<>(
                        () ->
                                scope.component(node.component())
                                        .map(
                                                named ->
                                                        named.chosen(
                                                                node.arguments(),
                                                                FeatureChoice.NONE))
                                        .map(components));
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

    /** The component under test, before a configuration of it is chosen. */
    public Optional<ComponentDeclaration> named() {
        return scope.component(node.component()).found();
    }

    /** The arguments for the component, typed against its parameters. */
    public List<GivenArgument> arguments() {
        return GivenArgument.of(
                named().map(named -> named.withoutFeatures(node.arguments()))
                        .orElse(node.arguments()),
                component().found().map(ComponentSymbol::parameters).orElse(List.of()),
                type -> type,
                (value, expected) -> ExpressionTyping.message(value, scope(expected), expected));
    }

    public List<StreamTestSymbol> tests() {
        return tests.get();
    }

    /** Fields with values that messages and arguments may name. */
    public List<VariableSymbol> fields() {
        return fields.get();
    }

    /** Where a constant of an enumeration is due, its name is no field's. */
    ValueScope scope(TypeSymbol expected) {
        return emptyScope()
                .with(
                        fields().stream()
                                .filter(field -> !isConstant(field.name(), expected))
                                .toList());
    }

    private static boolean isConstant(String name, TypeSymbol type) {
        return type instanceof EnumSymbol constants && constants.ordinal(name).isPresent();
    }

    private ValueScope emptyScope() {
        return ValueScope.empty(scope, scope::type);
    }

    private List<StreamTestSymbol> makeTests() {
        return node.members().stream()
                .filter(TestSuite.Test.class::isInstance)
                .map(member -> new StreamTestSymbol(this, (TestSuite.Test) member))
                .toList();
    }
}
