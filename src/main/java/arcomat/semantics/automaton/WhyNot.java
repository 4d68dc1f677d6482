package arcomat.semantics.automaton;

import arcomat.model.Automaton;
import arcomat.model.Refusal;
import arcomat.model.Refusal.Truth;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.semantics.expression.Clause;
import arcomat.semantics.expression.Evaluation;
import arcomat.semantics.expression.Fault;
import arcomat.semantics.expression.Guards;
import arcomat.semantics.expression.Term;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * Why a transition did not fire (a "why not" question, as in Ko and Myers 2004). Which ones did not
 * is what the {@link StepRelation} says; why, say the conditions that its guards are made of, one
 * by one. Pure, like the relation.
 */
public final class WhyNot {
    private final StepRelation relation;
    private final List<List<Asked>> asked = new ArrayList<>();

    /** A clause that is ready to be evaluated: what decides, and what tells why. */
    private record Asked(Clause clause, Term condition, Term value, ReadValues reads) {
        Refusal.Clause judged(Value[] messages, Value[] variables) {
            try {
                if (condition.holds(messages, variables)) {
                    return judged(Truth.TRUE, "");
                }
            } catch (Fault fault) {
                return judged(Truth.WRONG, fault.problem());
            }
            return isUndefined(messages, variables)
                    ? judged(Truth.UNDEFINED, reads.silent(messages, variables))
                    : judged(Truth.FALSE, reads.values(messages, variables));
        }

        private Refusal.Clause judged(Truth truth, String because) {
            return new Refusal.Clause(clause.text(), clause.effect(), truth, because);
        }

        /** What goes wrong where the condition does not even look is not defined there. */
        private boolean isUndefined(Value[] messages, Value[] variables) {
            try {
                return value.evaluate(messages, variables) == null;
            } catch (Fault fault) {
                return true;
            }
        }
    }

    private WhyNot(StepRelation relation) {
        this.relation = relation;
    }

    public static WhyNot of(StepRelation relation) {
        WhyNot whyNot = new WhyNot(relation);
        Guards guards = Guards.judging(relation.component().profile());
        for (Automaton.Transition transition : relation.automaton().transitions()) {
            whyNot.asked.add(
                    guards.clauses(relation.automaton(), transition).stream()
                            .map(each -> ready(each, relation))
                            .toList());
        }
        return whyNot;
    }

    private static Asked ready(Clause clause, StepRelation relation) {
        return new Asked(
                clause,
                Evaluation.compile(clause.condition(), relation.scope()),
                Evaluation.compile(clause.asked(), relation.scope()),
                ReadValues.of(clause.asked(), relation));
    }

    /** The transitions of the present state that may not be taken, in text order. */
    public List<Refusal> refusals(Configuration before, Input input) {
        if (!before.isState()) {
            return List.of();
        }
        Set<Integer> enabled =
                relation.choices(before, input).enabled().stream()
                        .map(Trace.Taken::index)
                        .collect(Collectors.toSet());
        Automaton automaton = relation.automaton();
        List<Refusal> refusals = new ArrayList<>();
        for (int i = 0; i < automaton.transitions().size(); i++) {
            if (automaton.transitions().get(i).source() == before.state() && !enabled.contains(i)) {
                refusals.add(refusal(i, before, relation.read(input)));
            }
        }
        return refusals;
    }

    private Refusal refusal(int index, Configuration before, Value[] messages) {
        Automaton.Transition transition = relation.automaton().transitions().get(index);
        List<Refusal.Clause> judged =
                asked.get(index).stream()
                        .map(each -> each.judged(messages, before.slots()))
                        .toList();
        return new Refusal(index, transition, relation.automaton().arrow(transition), judged);
    }

    /** The one that needed least to be taken; none where no transition leaves the state. */
    public Optional<Refusal> nearest(Configuration before, Input input) {
        return Refusal.nearest(refusals(before, input));
    }
}
