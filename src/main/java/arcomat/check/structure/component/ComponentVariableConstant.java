package arcomat.check.structure.component;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.expressions.VariableSymbol;
import arcomat.symbols.expressions.VariableSymbol.Kind;
import arcomat.symbols.signatures.BehaviourReader.Reading;
import arcomat.tree.Behaviour;
import arcomat.tree.Element;

/** ARC0128: a variable of a component that no automaton writes is a constant, and has a value. */
public final class ComponentVariableConstant implements Check.OnVariable {

    @Override
    public void check(VariableSymbol variable, Context context, Findings findings) {
        if (variable.kind() == Kind.COMPONENT
                && variable.node().initial().isEmpty()
                && !variable.type().isErroneous()
                && !isWritten(variable, context.component().orElseThrow())) {
            findings.report(
                    variable.nameSpan(),
                    "'%s' is written by no automaton of the component, so it is a constant and"
                            + " needs a value",
                    variable.name());
        }
    }

    /** Perhaps by what nobody has read: then that is told. */
    private static boolean isWritten(VariableSymbol variable, ComponentSymbol component) {
        return component.ownAutomata().stream()
                        .map(AutomatonSymbol::fields)
                        .anyMatch(fields -> fields.contains(variable))
                || !component.node().elements(Element.JavaPart.class).isEmpty()
                || component.node().elements(Behaviour.Foreign.class).stream()
                        .anyMatch(each -> isUnread(each, component));
    }

    private static boolean isUnread(Behaviour.Foreign behaviour, ComponentSymbol component) {
        Reading reading = component.readings().get(behaviour);
        return behaviour.automata().isEmpty() && (reading == null || reading.automaton().isEmpty());
    }
}
