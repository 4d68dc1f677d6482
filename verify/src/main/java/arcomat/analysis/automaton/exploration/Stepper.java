package arcomat.analysis.automaton.exploration;

import arcomat.analysis.automaton.exploration.Situation.Alternative;
import arcomat.analysis.reachability.Preconditions;
import arcomat.analysis.reachability.Subject;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.automaton.Input;
import arcomat.semantics.automaton.StepRelation;
import arcomat.semantics.automaton.StepRelation.Reaction;
import arcomat.semantics.expression.Fault;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiPredicate;
import java.util.function.ToIntFunction;

/**
 * Looks at what a letter does in a configuration.
 *
 * @param wrapping of each state the transitions of which an integer may wrap around
 * @param silencing of each state the transitions whose guards may negate what is silent
 */
public record Stepper(
        Subject subject, List<List<Wrapping>> wrapping, List<List<Silencing>> silencing) {

    /** When a transition lacks nothing but messages that its guard negates. */
    public record Silencing(int transition, BiPredicate<Configuration, Input> condition) {}

    /** When an integer of a transition wraps around. */
    public record Wrapping(
            int transition,
            BiPredicate<Configuration, Input> inGuard,
            BiPredicate<Configuration, Input> inEffect) {}

    public static Stepper of(Subject subject) {
        List<List<Wrapping>> wrapping = new ArrayList<>();
        List<List<Silencing>> silencing = new ArrayList<>();
        for (int state = 0; state < subject.automaton().states().size(); state++) {
            wrapping.add(new ArrayList<>(0));
            silencing.add(new ArrayList<>(0));
        }
        for (int i = 0; i < subject.preconditions().size(); i++) {
            Preconditions condition = subject.preconditions().get(i);
            if (condition.mayWrap()) {
                wrapping.get(subject.transition(i).source()).add(wrapping(subject, i, condition));
            }
        }
        for (int i : subject.silenceable()) {
            Expression silenced = subject.preconditions().get(i).enabledButForSilence();
            silencing
                    .get(subject.transition(i).source())
                    .add(new Silencing(i, subject.relation().condition(silenced)));
        }
        return new Stepper(subject, wrapping, silencing);
    }

    private static Wrapping wrapping(Subject subject, int transition, Preconditions condition) {
        return new Wrapping(
                transition,
                subject.relation().condition(condition.wrapsInGuard()),
                subject.relation().condition(condition.wrapsInEffect()));
    }

    /**
     * @param next the number of the visit that a reaction leads to
     */
    public Situation situation(Visit visit, Value[] letter, ToIntFunction<Reaction> next) {
        Input input = Input.of(letter);
        List<Alternative> alternatives = new ArrayList<>();
        StepRelation.Choices choices = subject.relation().choices(visit.configuration(), input);
        for (Trace.Taken taken : choices.enabled()) {
            alternatives.add(alternative(taken, visit, input, next));
        }
        boolean answered = !alternatives.isEmpty() || !choices.faults().isEmpty();
        return new Situation(
                visit,
                letter,
                alternatives,
                choices.faults(),
                wrapping(visit.configuration(), input, choices.enabled()),
                answered ? List.of() : silenced(visit.configuration(), input));
    }

    private List<Integer> silenced(Configuration configuration, Input input) {
        return silencing.get(configuration.state()).stream()
                .filter(each -> each.condition.test(configuration, input))
                .map(Silencing::transition)
                .toList();
    }

    private List<Integer> wrapping(
            Configuration configuration, Input input, List<Trace.Taken> enabled) {
        List<Integer> found = new ArrayList<>(0);
        for (Wrapping each : wrapping.get(configuration.state())) {
            boolean taken = enabled.stream().anyMatch(t -> t.index() == each.transition);
            if (each.inGuard.test(configuration, input)
                    || taken && each.inEffect.test(configuration, input)) {
                found.add(each.transition);
            }
        }
        return found;
    }

    private Alternative alternative(
            Trace.Taken taken, Visit visit, Input input, ToIntFunction<Reaction> next) {
        try {
            Reaction reaction = subject.relation().take(taken, visit.configuration(), input);
            return new Alternative(
                    taken, Optional.of(reaction), Optional.empty(), next.applyAsInt(reaction));
        } catch (Fault fault) {
            return new Alternative(taken, Optional.empty(), Optional.of(fault), -1);
        }
    }

    /** The latched ports that have had a message after a letter. */
    public Set<Integer> latched(Visit before, Value[] letter) {
        if (subject.component().profile() == Component.Profile.TIME_SYNCHRONOUS) {
            return Set.of();
        }
        List<Port> inputs = subject.component().inputs();
        Set<Integer> latched = new HashSet<>(before.latched());
        for (int port = 0; port < letter.length; port++) {
            if (inputs.get(port).latched() && letter[port] != null) {
                latched.add(port);
            }
        }
        return latched;
    }
}
