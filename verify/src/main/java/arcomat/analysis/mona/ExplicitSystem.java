package arcomat.analysis.mona;

import arcomat.analysis.mona.InclusionProblem.NotForMona;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.letter.LetterClasses;
import arcomat.analysis.search.step.OutputCubes;
import arcomat.analysis.search.step.Steps;
import arcomat.analysis.search.system.TransitionSystem;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.semantics.expression.Output;
import arcomat.semantics.value.MessageClasses;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.IntStream;

/**
 * One side spelled out: all its configurations with all steps out of them. The step relation is
 * asked once for each kind of letter that a configuration tells apart.
 *
 * @param title as messages name it
 * @param inputs what it reads, in the order of {@link TransitionSystem#inputs}
 */
record ExplicitSystem(
        String title, List<PortTrack> inputs, List<Step> openings, List<State> states) {
    private static final int MOST_STATES = 4096;
    private static final int MOST_LETTERS = 1 << 16;

    /**
     * A configuration.
     *
     * @param chaos any output may be sent from here on
     */
    record State(String name, boolean chaos, List<Step> steps) {}

    /**
     * Equal reactions to some letters.
     *
     * @param inputs per input the codes with which the step is taken
     * @param error whether the run ends here, so that nothing is sent
     * @param sent on the compared ports; where the run ends, what earlier reactions still show,
     *     null for nothing
     * @param whole on all ports
     */
    record Step(
            List<Set<Integer>> inputs,
            boolean error,
            @Nullable Output sent,
            Output whole,
            int next,
            List<Trace.Cause> causes) {}

    /**
     * @throws NotForMona where there are too many configurations or letters
     */
    static ExplicitSystem explore(
            String title,
            TransitionSystem side,
            List<PortTrack> inputs,
            OutputCubes outputs,
            Budget budget) {
        Enumeration enumeration = new Enumeration(side, inputs, outputs, budget);
        List<Step> openings = enumeration.openings();
        List<State> states = new ArrayList<>();
        for (int number = 0; number < side.size(); number++) {
            String exhausted = budget.exhausted(number);
            if (exhausted != null || number >= MOST_STATES) {
                throw new NotForMona(
                        exhausted != null
                                ? exhausted
                                : "more than " + MOST_STATES + " states are too many for MONA");
            }
            states.add(
                    new State(
                            side.describe(number),
                            side.isChaos(number),
                            enumeration.steps(number)));
        }
        return new ExplicitSystem(title, inputs, openings, states);
    }

    /**
     * The number of a state, in binary.
     *
     * @param name of the predicate for this system
     */
    Bits stateBits(String name) {
        return Bits.named(name + "State", states.size());
    }

    /** Whether some run ends with an error. */
    boolean mayFail() {
        return states.stream().anyMatch(state -> state.steps.stream().anyMatch(Step::error));
    }

    /** What makes steps equal but for their letters. */
    private record Key(int output, int next, List<Trace.Cause> causes, Output whole) {}

    private record Enumeration(
            TransitionSystem side, List<PortTrack> inputs, OutputCubes outputs, Budget budget) {

        List<Step> steps(int number) {
            LetterClasses focus = side.letterClasses(number);
            int[] positions = IntStream.range(0, inputs.size()).toArray();
            Map<Key, List<List<Set<Integer>>>> found = new LinkedHashMap<>();
            for (List<Set<Integer>> kind : kinds(focus)) {
                budget.insist();
                Value[] letter = new Value[inputs.size()];
                for (int port = 0; port < letter.length; port++) {
                    int sample = kind.get(port).iterator().next();
                    letter[port] = inputs.get(port).message(sample).orElse(null);
                }
                Steps steps = side.steps(number, focus.kind(letter, positions), letter);
                for (int i = 0; i < steps.size(); i++) {
                    found.computeIfAbsent(key(steps, i), each -> new ArrayList<>()).add(kind);
                }
            }
            List<Step> all = new ArrayList<>();
            found.forEach((key, kinds) -> merged(kinds).forEach(k -> all.add(step(key, k))));
            return all;
        }

        List<Step> openings() {
            Steps steps = side.openings();
            return IntStream.range(0, steps.size())
                    .mapToObj(i -> step(key(steps, i), List.of()))
                    .toList();
        }

        private static Key key(Steps steps, int i) {
            return new Key(
                    steps.outputs()[i],
                    steps.next()[i],
                    steps.causes().get(i),
                    steps.whole().get(i));
        }

        private Step step(Key key, List<Set<Integer>> kind) {
            return new Step(
                    kind,
                    !outputs.isLetter(key.output),
                    outputs.cube(key.output),
                    key.whole,
                    key.next,
                    key.causes);
        }

        /** Letters that look alike, as sets of codes per port. */
        private List<List<Set<Integer>>> kinds(LetterClasses focus) {
            List<List<Set<Integer>>> kinds = List.of(List.of());
            for (int port = 0; port < inputs.size(); port++) {
                List<Set<Integer>> own = kinds(focus, port);
                if ((long) kinds.size() * own.size() > MOST_LETTERS) {
                    throw new NotForMona(
                            "one state tells more than "
                                    + MOST_LETTERS
                                    + " inputs apart, too many for MONA");
                }
                List<List<Set<Integer>>> longer = new ArrayList<>();
                for (List<Set<Integer>> kind : kinds) {
                    for (Set<Integer> codes : own) {
                        List<Set<Integer>> copy = new ArrayList<>(kind);
                        copy.add(codes);
                        longer.add(copy);
                    }
                }
                kinds = longer;
            }
            return kinds;
        }

        private List<Set<Integer>> kinds(LetterClasses focus, int port) {
            PortTrack track = inputs.get(port);
            MessageClasses kinds =
                    MessageClasses.of(
                            track.port(), track.total(), focus.abstraction().looks().get(port));
            Map<Integer, Set<Integer>> codes = new LinkedHashMap<>();
            for (int code : track.codes()) {
                int kind = kinds.of(track.message(code).orElse(null));
                codes.computeIfAbsent(kind, each -> new TreeSet<>()).add(code);
            }
            return List.copyOf(codes.values());
        }

        /** MessageClasses that differ in one port become one, port by port. */
        private List<List<Set<Integer>>> merged(List<List<Set<Integer>>> kinds) {
            List<List<Set<Integer>>> merged = kinds;
            for (int port = 0; port < inputs.size(); port++) {
                Map<List<Set<Integer>>, Set<Integer>> byRest = new LinkedHashMap<>();
                for (List<Set<Integer>> kind : merged) {
                    List<Set<Integer>> rest = new ArrayList<>(kind);
                    Set<Integer> codes = rest.set(port, Set.of());
                    byRest.computeIfAbsent(rest, each -> new TreeSet<>()).addAll(codes);
                }
                List<List<Set<Integer>>> fewer = new ArrayList<>();
                for (Map.Entry<List<Set<Integer>>, Set<Integer>> each : byRest.entrySet()) {
                    List<Set<Integer>> kind = new ArrayList<>(each.getKey());
                    kind.set(port, each.getValue());
                    fewer.add(kind);
                }
                merged = fewer;
            }
            return merged;
        }
    }
}
