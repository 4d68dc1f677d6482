package arcomat.symbols.bodies;

import arcomat.symbols.expressions.ExpressionTyping;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.expressions.ValueScope;
import arcomat.symbols.expressions.VariableSymbol;
import arcomat.symbols.names.Lazy;
import arcomat.symbols.names.Resolution;
import arcomat.symbols.names.TypeSymbol;
import arcomat.symbols.signatures.Timing;
import arcomat.tree.Automaton;
import arcomat.tree.AutomatonElement;
import arcomat.tree.Element;
import arcomat.tree.Variable;

import java.util.ArrayList;
import java.util.List;

/** What an automaton declares besides states. */
final class AutomatonDeclarations {
    private final Automaton node;
    private final ValueScope constants;
    private final Lazy<List<PortSymbol>> ports = new Lazy<>(this::makePorts);
    private final Lazy<List<VariableSymbol>> variables = new Lazy<>(this::makeVariables);

    AutomatonDeclarations(Automaton node, ValueScope constants) {
        this.node = node;
        this.constants = constants;
    }

    /** What initial values may read, the variables of the automaton itself left out. */
    ValueScope constants() {
        return constants;
    }

    List<PortSymbol> ports() {
        return ports.get();
    }

    List<VariableSymbol> variables() {
        return variables.get();
    }

    private List<PortSymbol> makePorts() {
        List<PortSymbol> all = new ArrayList<>();
        for (var declaration : node.elements(AutomatonElement.Declaration.class)) {
            if (declaration.kind() != AutomatonElement.Kind.VARIABLE) {
                declaration.variables().forEach(v -> all.add(port(declaration, v)));
            }
        }
        return List.copyOf(all);
    }

    private PortSymbol port(AutomatonElement.Declaration declaration, Variable variable) {
        boolean input = declaration.kind() == AutomatonElement.Kind.INPUT;
        return new PortSymbol(
                variable.name().text(),
                variable.name().span(),
                false,
                input ? Element.Direction.IN : Element.Direction.OUT,
                declaration.type(),
                constants.type(declaration.type()),
                List.of(),
                Timing.DEFAULT.delay());
    }

    private List<VariableSymbol> makeVariables() {
        List<VariableSymbol> all = new ArrayList<>();
        for (var declaration : node.elements(AutomatonElement.Declaration.class)) {
            if (declaration.kind() == AutomatonElement.Kind.VARIABLE) {
                Resolution<TypeSymbol> type = constants.type(declaration.type());
                for (Variable variable : declaration.variables()) {
                    all.add(
                            new VariableSymbol(
                                    VariableSymbol.Kind.AUTOMATON,
                                    variable,
                                    type,
                                    ExpressionTyping.at(constants)));
                }
            }
        }
        return List.copyOf(all);
    }
}
