package arcomat.check.structure.component;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.expressions.VariableSymbol;
import arcomat.symbols.expressions.VariableSymbol.Kind;
import arcomat.symbols.signatures.BehaviourReader.Reading;
import arcomat.tree.Behaviour;
import arcomat.tree.Element;

import java.util.List;

/**
 * ARC0128: a variable of a component that no automaton writes is a constant, and has a value. One
 * that does not say what it does may leave that open, and the first heir that says so may not.
 */
public final class ComponentVariableConstant implements Check.OnVariable, Check.OnComponent {

    @Override
    public void check(VariableSymbol variable, Context context, Findings findings) {
        if (variable.kind() == Kind.COMPONENT
                && hasNoValue(variable, context.component().orElseThrow())) {
            findings.report(
                    variable.nameSpan(),
                    "'%s' is written by no automaton of the component, so it is a constant and"
                            + " needs a value",
                    variable.name());
        }
    }

    @Override
    public void check(ComponentSymbol heir, Context context, Findings findings) {
        List<ComponentSymbol> ancestors = heir.lineage().subList(1, heir.lineage().size());
        if (!ancestors.stream().allMatch(ComponentVariableConstant::isSilent)) {
            return;
        }
        for (ComponentSymbol ancestor : ancestors) {
            for (VariableSymbol variable : ancestor.signature().ownVariables()) {
                if (hasNoValue(variable, heir)) {
                    findings.report(
                                    heir.node().superComponent().orElseThrow().name(),
                                    "'%s' of '%s' is written by no automaton of this component, so"
                                            + " it is a constant and needs a value",
                                    variable.name(),
                                    ancestor.name())
                            .related(variable.nameSpan(), "declared here");
                }
            }
        }
    }

    private static boolean hasNoValue(VariableSymbol variable, ComponentSymbol component) {
        return variable.node().initial().isEmpty()
                && !variable.type().isErroneous()
                && !isSilent(component)
                && !isWritten(variable, component);
    }

    /** Whether nothing in the component could read a variable. */
    private static boolean isSilent(ComponentSymbol component) {
        return !component.isDecomposed()
                && component.ownAutomata().isEmpty()
                && component.ownInvariants().isEmpty()
                && component.node().elements(Behaviour.Foreign.class).isEmpty()
                && component.signature().ownVariables().stream()
                        .allMatch(each -> each.node().initial().isEmpty());
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
