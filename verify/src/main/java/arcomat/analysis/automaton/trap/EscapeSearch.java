package arcomat.analysis.automaton.trap;

import arcomat.analysis.automaton.exploration.Situation;
import arcomat.analysis.automaton.exploration.Situation.Alternative;
import arcomat.analysis.automaton.exploration.Stepper;
import arcomat.analysis.automaton.exploration.SureSending;
import arcomat.analysis.automaton.exploration.Visit;
import arcomat.analysis.automaton.induction.Move;
import arcomat.analysis.automaton.trap.EscapePlan.Step;
import arcomat.analysis.reachability.Logic;
import arcomat.analysis.reachability.Reachability.Place;
import arcomat.analysis.reachability.Reachability.Run;
import arcomat.analysis.reachability.Subject;
import arcomat.analysis.reachability.SymbolicTransitions;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.automaton.StepRelation.Reaction;
import arcomat.semantics.expression.Output;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.BooleanSupplier;

/**
 * Looks for shortest plans from one configuration: with runs of 0, 1, 2, .. inputs from there. What
 * the automaton itself does not do is no plan.
 *
 * @param <T> formulas of the solver
 */
final class EscapeSearch<T> {
    private static final int NEAR = 2;

    private final Subject subject;
    private final List<Move> moves;
    private final PlanConditions conditions;
    private final Stepper stepper;
    private final RunsFromSpot<T> runs;

    EscapeSearch(Subject subject, List<Move> moves, Logic.Kind<T> kind, BooleanSupplier stop) {
        this.subject = subject;
        this.moves = moves;
        this.conditions = PlanConditions.of(subject);
        this.stepper = Stepper.of(subject);
        this.runs = new RunsFromSpot<>(subject, kind, stop);
    }

    /** Whether nothing so far had to be replaced by something that may be anything. */
    boolean isExact() {
        return runs.isExact();
    }

    /** A plan of few steps from there; nothing where there is none, or none is found. */
    Optional<EscapePlan> near(Spot spot, Goals goals) {
        return from(spot, 0, NEAR, goals);
    }

    /** A plan of more steps. */
    Optional<EscapePlan> far(Spot spot, Goals goals) {
        return from(spot, NEAR + 1, RunsFromSpot.LONGEST, goals);
    }

    private Optional<EscapePlan> from(Spot spot, int least, int most, Goals goals) {
        Optional<Expression> measured =
                goals.measure().map(each -> spot.value(each.value(), subject));
        return runs.shortest(
                        spot,
                        least,
                        most,
                        (length, there, logic) ->
                                length == 0
                                        ? escapes(there, logic)
                                        : logic.or(
                                                List.of(
                                                        escapes(there, logic),
                                                        goals.at(there, measured, logic))))
                .flatMap(run -> plan(spot, run, goals));
    }

    private T escapes(SymbolicTransitions<T> there, Logic<T> logic) {
        List<T> any = new ArrayList<>();
        for (Move move : moves) {
            any.add(
                    logic.and(
                            List.of(
                                    there.instant().isIn(move.source()),
                                    there.holds(move.escapes()))));
        }
        return logic.or(any);
    }

    private Optional<EscapePlan> plan(Spot spot, Run run, Goals goals) {
        Visit visit =
                new Visit(
                        -1,
                        spot.configuration(),
                        Set.of(),
                        null,
                        null,
                        new Output(List.of()),
                        0,
                        0);
        List<Step> steps = new ArrayList<>();
        for (int i = 0; i < run.letters().size(); i++) {
            Value[] letter = run.letters().get(i);
            Optional<Alternative> taken = taken(visit, letter, run.places().get(i + 1));
            if (taken.isEmpty()) {
                return Optional.empty();
            }
            Reaction reaction = taken.get().reaction().orElseThrow();
            steps.add(step(taken.get().taken().index(), letter));
            visit = visit.then(reaction, Set.of(), letter);
        }
        return ended(steps, visit, run.last(), spot, goals);
    }

    private Optional<Alternative> taken(Visit visit, Value[] letter, Place place) {
        return situation(visit, letter).alternatives().stream()
                .filter(each -> each.reaction().filter(r -> isAt(r.next(), place)).isPresent())
                .findFirst();
    }

    private static boolean isAt(Configuration configuration, Place place) {
        return configuration.state() == place.state()
                && configuration.variables().equals(place.variables());
    }

    private Situation situation(Visit visit, Value[] letter) {
        return stepper.situation(visit, letter, reaction -> -1);
    }

    private Step step(int transition, Value[] letter) {
        List<Optional<Expression>> messages = new ArrayList<>();
        for (int i = 0; i < letter.length; i++) {
            Port port = subject.component().inputs().get(i);
            messages.add(
                    Optional.ofNullable(letter[i])
                            .map(each -> new Expression.Constant(each, port.type(), port.span())));
        }
        return new Step(moves.get(transition), messages);
    }

    /** What the last letter does, or that it is not needed any more. */
    private Optional<EscapePlan> ended(
            List<Step> steps, Visit end, Value[] last, Spot spot, Goals goals) {
        List<EscapePlan> plans = new ArrayList<>();
        Situation situation = situation(end, last);
        situation.faults().forEach(each -> plans.add(escape(steps, each.taken(), last)));
        situation.alternatives().stream()
                .filter(this::escapes)
                .forEach(each -> plans.add(escape(steps, Optional.of(each.taken()), last)));
        if (!steps.isEmpty()) {
            boolean settles = goals.settled().contains(end.configuration().state());
            plans.add(
                    new EscapePlan(
                            steps, settles ? EscapePlan.Goal.SETTLES : EscapePlan.Goal.PROGRESSES));
        }
        return plans.stream().filter(each -> isPossible(each, spot, goals)).findFirst();
    }

    private EscapePlan escape(List<Step> steps, Optional<Trace.Taken> taken, Value[] last) {
        List<Step> all = new ArrayList<>(steps);
        all.add(step(taken.orElseThrow().index(), last));
        return new EscapePlan(all, EscapePlan.Goal.ESCAPES);
    }

    private boolean escapes(Alternative each) {
        return each.fault().isPresent() || SureSending.sends(subject, each.taken().transition());
    }

    private boolean isPossible(EscapePlan plan, Spot spot, Goals goals) {
        return goals.condition(plan, conditions)
                .filter(condition -> spot.satisfies(condition, subject))
                .isPresent();
    }
}
