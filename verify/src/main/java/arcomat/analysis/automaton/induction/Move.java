package arcomat.analysis.automaton.induction;

import arcomat.analysis.automaton.exploration.Knowledge;
import arcomat.analysis.automaton.exploration.SureSending;
import arcomat.analysis.reachability.Preconditions;
import arcomat.analysis.reachability.RunProperty;
import arcomat.analysis.reachability.Subject;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Parameter;
import arcomat.model.Variable;
import arcomat.semantics.expression.Fault;
import arcomat.semantics.expression.Formulas;
import arcomat.semantics.expression.Replacement;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;

/**
 * What a transition does to the variables and what it asks for that, over variables and messages.
 *
 * @param transition its index
 * @param goesOn it may be taken, and all goes well
 * @param escapes it may be taken and sends, or it goes wrong: no trap begins where that is possible
 * @param assigned what variables are afterwards, by name; others stay
 * @param dead whether no run takes it
 */
public record Move(
        int transition,
        int source,
        int target,
        Expression goesOn,
        Expression escapes,
        Map<String, Expression> assigned,
        boolean dead) {

    /** Of each transition, in text order. */
    public static List<Move> all(Knowledge known) {
        Replacement names = names(known.subject());
        return IntStream.range(0, known.subject().automaton().transitions().size())
                .mapToObj(each -> of(each, names, known))
                .toList();
    }

    /** Parameters and constants have values. */
    private static Replacement names(Subject subject) {
        Component component = subject.component();
        Map<String, Expression> parameters = new HashMap<>();
        for (int i = 0; i < subject.arguments().size(); i++) {
            Parameter each = component.parameters().get(i);
            parameters.put(
                    each.name(),
                    new Expression.Constant(
                            subject.arguments().get(i), each.type(), component.span()));
        }
        Map<String, Expression> constants = new HashMap<>();
        for (Variable each : component.constants()) {
            Expression value = new Replacement(Map.of(), constants, parameters).of(each.initial());
            constants.put(each.name(), value);
        }
        subject.automaton().variables().forEach(each -> constants.remove(each.name()));
        return new Replacement(Map.of(), constants, parameters);
    }

    private static Move of(int index, Replacement names, Knowledge known) {
        Automaton.Transition transition = known.subject().transition(index);
        Preconditions when = known.subject().preconditions().get(index);
        Expression asked = Formulas.and(Formulas.not(when.dividesInGuard()), when.enabled());
        Expression wrong = Formulas.or(when.dividesInEffect(), when.leavesRange());
        Map<String, Expression> assigned = new LinkedHashMap<>();
        transition
                .assignments()
                .forEach(each -> assigned.put(each.variable().name(), names.of(each.value())));
        return new Move(
                index,
                transition.source(),
                transition.target(),
                names.of(
                        Formulas.and(
                                asked,
                                Formulas.and(
                                        Formulas.not(when.dividesInEffect()),
                                        Formulas.not(when.leavesRange())))),
                names.of(escapes(index, when.dividesInGuard(), asked, wrong, known)),
                assigned,
                isDead(index, known));
    }

    private static boolean isDead(int index, Knowledge known) {
        return known.neverHappens(new RunProperty.Enabled(index));
    }

    /** Where it is known that something never happens, nobody has to look out for it. */
    private static Expression escapes(
            int index,
            Expression guardGoesWrong,
            Expression asked,
            Expression wrong,
            Knowledge known) {
        boolean guarded =
                known.neverHappens(new RunProperty.Wrong(index, Fault.Kind.DIVISION_BY_ZERO));
        Expression inGuard = guarded ? Formulas.FALSE : guardGoesWrong;
        if (isDead(index, known)) {
            return inGuard;
        }
        boolean sends = SureSending.sends(known.subject(), known.subject().transition(index));
        return Formulas.or(inGuard, sends ? asked : Formulas.and(asked, wrong));
    }
}
