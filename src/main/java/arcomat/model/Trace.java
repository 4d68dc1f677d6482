package arcomat.model;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;

/**
 * What a run showed, step by step, each port in the slice in which it is visible.
 *
 * @param component the component that ran
 * @param failure why the run ended early, if it did
 * @param opening event-driven, what of the first step was sent before its event; empty where the
 *     run did not come so far
 * @param end the step that the run ended in, where that is an error that a model may allow
 */
public record Trace(
        Component component,
        List<Step> steps,
        Optional<String> failure,
        Optional<Letter> opening,
        Optional<End> end) {
    public Trace {
        steps = List.copyOf(steps);
    }

    public Trace(Component component, List<Step> steps, Optional<String> failure) {
        this(component, steps, failure, Optional.empty(), Optional.empty());
    }

    /** The same with other steps. */
    public Trace with(List<Step> other) {
        return new Trace(component, other, failure, opening, end);
    }

    /** Per step what came in, the one in which the run goes wrong included. */
    public List<Letter> received() {
        return withEnd(Step::inputs, End::inputs);
    }

    /** Per step what was to be seen, the one in which the run goes wrong included. */
    public List<Letter> shown() {
        return withEnd(Step::outputs, End::shown);
    }

    /** An event-driven run that goes wrong before its first event has not come to that. */
    private List<Letter> withEnd(Function<Step, Letter> step, Function<End, Letter> last) {
        boolean begun =
                component.profile() == Component.Profile.TIME_SYNCHRONOUS || opening.isPresent();
        List<Letter> letters = new ArrayList<>();
        steps.forEach(each -> letters.add(step.apply(each)));
        end.filter(any -> begun).ifPresent(any -> letters.add(last.apply(any)));
        return letters;
    }

    /**
     * The step in which a run goes wrong.
     *
     * @param shown what its outputs show in spite of that: what was sent before
     */
    public record End(Letter inputs, Letter shown) {}

    /**
     * One slice (time-synchronous) or one event (event-driven).
     *
     * @param number from 0
     * @param between what parts send, each port by its path, {@code mind.speed}; silent where
     *     nobody has asked
     */
    public record Step(
            int number, Letter inputs, Letter outputs, List<Activity> activities, Letter between) {
        public Step {
            activities = List.copyOf(activities);
        }

        /** A step of which nobody has asked what parts send. */
        public Step(int number, Letter inputs, Letter outputs, List<Activity> activities) {
            this(number, inputs, outputs, activities, Letter.SILENCE);
        }
    }

    /**
     * What one automaton did in a step.
     *
     * @param instance path of the instance in the component that ran, empty for itself
     * @param automaton name of the automaton, empty where it has none
     * @param before name of the state before the step
     * @param after name of the state after the step
     * @param cause what made the step
     * @param variables values after the step, in the order of declaration
     * @param nearest where no transition was enabled, the one that needed least; empty where nobody
     *     has asked, or none leaves the state
     */
    public record Activity(
            String instance,
            String automaton,
            String before,
            String after,
            Cause cause,
            Map<String, Value> variables,
            Optional<Refusal> nearest) {}

    /** A transition, or a completion. */
    public sealed interface Cause {}

    /**
     * @param index position in {@link Automaton#transitions}
     */
    public record Taken(int index, Automaton.Transition transition) implements Cause {}

    public record Completed(Automaton.Completion completion) implements Cause {}
}
