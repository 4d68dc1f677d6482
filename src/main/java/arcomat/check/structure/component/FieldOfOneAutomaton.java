package arcomat.check.structure.component;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.ItemSymbol;
import arcomat.symbols.expressions.Typed;
import arcomat.symbols.expressions.VariableSymbol;
import arcomat.tree.Node;

import java.util.Optional;

/**
 * ARC0140: a variable of a component that an automaton writes belongs to that automaton. Several
 * automata say together what is allowed, and none of them sees what another one remembers.
 */
public final class FieldOfOneAutomaton implements Check.OnItem, Check.OnExpression {

    @Override
    public void check(ItemSymbol item, Context context, Findings findings) {
        if (item.target().found().orElse(null) instanceof VariableSymbol variable) {
            check(
                    variable,
                    item.node().name().<Node>map(name -> name).orElse(item.node()),
                    context,
                    findings);
        }
    }

    /** Initial values are not of any automaton: they are the business of {@link FieldReadEarly}. */
    @Override
    public void check(Typed expression, Context context, Findings findings) {
        if (FieldReadEarly.isEarly(context)) {
            return;
        }
        expression
                .variablesRead()
                .forEach(read -> check(read.variable(), read.node(), context, findings));
    }

    private static void check(
            VariableSymbol variable, Node place, Context context, Findings findings) {
        Optional<AutomatonSymbol> owner =
                context.component().flatMap(component -> owner(variable, component));
        if (owner.isPresent() && !owner.equals(context.automaton())) {
            findings.report(
                            place,
                            "'%s' changes with %s, and no other behaviour sees it; give this one a"
                                    + " variable of its own, or write one automaton",
                            variable.name(),
                            owner.get().name().isEmpty()
                                    ? "the first automaton that writes it"
                                    : "automaton '" + owner.get().name() + "'")
                    .related(variable.nameSpan(), "declared here");
        }
    }

    /** The first automaton that writes it. */
    private static Optional<AutomatonSymbol> owner(
            VariableSymbol variable, ComponentSymbol component) {
        return component.ownAutomata().stream()
                .filter(automaton -> automaton.fields().contains(variable))
                .findFirst();
    }
}
