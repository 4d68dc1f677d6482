package arcomat.analysis.search.product;

import arcomat.analysis.search.Budget;
import arcomat.analysis.search.Moment;
import arcomat.analysis.search.letter.Alphabet;
import arcomat.analysis.search.step.CubeSplit;
import arcomat.analysis.search.step.OutputCubes;
import arcomat.analysis.search.step.Steps;
import arcomat.analysis.search.system.TransitionSystem;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.semantics.expression.Output;
import arcomat.semantics.expression.Sent;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Compares two sides, and tells a failure moment by moment. */
public final class Comparison {
    private final List<Port> leftOutputs;
    private final List<String> observed;
    private final Product pairing;
    private final TraceInclusion inclusion;

    /**
     * @param observed the output ports of the right side, as cubes list them
     */
    public Comparison(
            TransitionSystem left,
            TransitionSystem right,
            List<Port> observed,
            OutputCubes outputs,
            Budget budget) {
        this.leftOutputs = left.outputs();
        this.observed = observed.stream().map(Port::name).toList();
        this.pairing = new Product(left, right, observed, outputs, budget);
        this.inclusion = new TraceInclusion(pairing, budget);
    }

    /** Ends with the first failure, or where time, memory or letters are too much. */
    public TraceInclusion.Result run() {
        return inclusion.search();
    }

    /** As {@link #run}, but goes on behind failures. */
    public TraceInclusion.Result runOn() {
        return inclusion.search(true);
    }

    /** How many pairs were explored so far. */
    public long pairs() {
        return inclusion.pairs();
    }

    /** One failure for each cause of a forbidden step, the shortest. */
    public List<TraceInclusion.Failure> failures() {
        return inclusion.failures();
    }

    /** Why it holds, where it does. */
    public Certificate certificate() {
        return inclusion.certificate();
    }

    /**
     * The step that the right side forbids.
     *
     * @param causes what the left side did; empty for a beginning
     * @param sent what it sent
     * @param error what its run ended in instead, in words; empty if it goes on
     * @param left the configuration before, in words
     * @param right what the right side may be in before, and what each step of it allows
     */
    public record Forbidden(
            List<Trace.Cause> causes,
            Map<String, Sent> sent,
            Optional<String> error,
            String left,
            List<Allowed> right) {}

    /**
     * What one step of the right side allows.
     *
     * @param configuration before the step, in words
     */
    public record Allowed(
            String configuration,
            List<Trace.Cause> causes,
            Map<String, Sent> sent,
            boolean error) {}

    /** The moments of a failure, the forbidden one included. */
    public List<Moment> moments(TraceInclusion.Failure failure) {
        List<Moment> moments = new ArrayList<>();
        List<Integer> path = inclusion.path(failure.node());
        Steps openings = pairing.left.openings();
        if (path.isEmpty()) {
            moments.add(moment(null, failure.steps(), failure.step(), failure.sent(), List.of()));
            return moments;
        }
        moments.add(opening(openings, path.get(0)));
        for (int i = 1; i < path.size(); i++) {
            moments.add(between(path.get(i - 1), path.get(i)));
        }
        moments.add(
                moment(
                        failure.alphabet().letter(failure.letter()),
                        failure.steps(),
                        failure.step(),
                        failure.sent(),
                        List.of()));
        return moments;
    }

    private Moment opening(Steps mine, int node) {
        Steps theirs = pairing.right.openings();
        for (int step = 0; step < mine.size(); step++) {
            for (CubeSplit.Case sent : pairing.cases(mine.outputs()[step], theirs)) {
                if (mine.next()[step] == inclusion.left(node)
                        && sent.messages() == inclusion.cost(node)
                        && inclusion.successor(theirs, sent.allowed()) == inclusion.set(node)) {
                    return moment(null, mine, step, sent, set(node));
                }
            }
        }
        throw new AssertionError("no beginning leads to the first pair");
    }

    /** The step between two pairs, found again. */
    private Moment between(int before, int after) {
        int left = inclusion.left(before);
        Alphabet alphabet = pairing.alphabet(left, inclusion.set(before));
        int gain = inclusion.cost(after) - inclusion.cost(before);
        for (int letter = 0; letter < alphabet.size(); letter++) {
            Steps mine =
                    pairing.left.steps(left, alphabet.kind(0, letter), alphabet.letter(letter));
            Steps theirs = inclusion.answers(inclusion.set(before), alphabet, letter);
            for (int step = 0; step < mine.size(); step++) {
                if (mine.next()[step] != inclusion.left(after)) {
                    continue;
                }
                for (CubeSplit.Case sent : pairing.cases(mine.outputs()[step], theirs)) {
                    if (sent.allowed().length > 0
                            && alphabet.messages(letter) + sent.messages() == gain
                            && inclusion.successor(theirs, sent.allowed())
                                    == inclusion.set(after)) {
                        return moment(alphabet.letter(letter), mine, step, sent, set(after));
                    }
                }
            }
        }
        throw new AssertionError("no step between two pairs of a path");
    }

    private List<String> set(int node) {
        return Arrays.stream(pairing.sets.members(inclusion.set(node)))
                .mapToObj(pairing.right::describe)
                .toList();
    }

    private Moment moment(
            Value[] letter, Steps mine, int step, CubeSplit.Case sent, List<String> right) {
        return new Moment(
                letter == null ? Letter.SILENCE : Letter.of(pairing.left.inputs(), letter),
                sent(mine.whole().get(step), sent),
                sent.error() ? "error" : pairing.left.describe(mine.next()[step]),
                right,
                sent.error());
    }

    /**
     * On compared ports, and on those that show the same message, the sample; on others what the
     * left side sends there. Where the run ends, only what is still seen.
     */
    private Map<String, Sent> sent(Output whole, CubeSplit.Case sent) {
        Map<String, String> twins = pairing.left.twins();
        Map<String, Sent> shown = new LinkedHashMap<>();
        for (int i = 0; i < leftOutputs.size(); i++) {
            String name = leftOutputs.get(i).name();
            int compared = observed.indexOf(observed.contains(name) ? name : twins.get(name));
            if (compared >= 0) {
                shown.put(name, sent.sample().ports().get(compared));
            } else if (!sent.error()) {
                shown.put(name, whole.ports().get(i));
            }
        }
        if (sent.error()) {
            shown.values().removeIf(Sent.SILENCE::equals);
        }
        return shown;
    }

    /** The last moment of a failure, from both sides. */
    public Forbidden forbidden(TraceInclusion.Failure failure) {
        List<Allowed> allowed = new ArrayList<>();
        String before = "";
        if (failure.node() < 0) {
            addAllowed("", pairing.right.openings(), allowed);
        } else {
            before = pairing.left.describe(inclusion.left(failure.node()));
            int set = inclusion.set(failure.node());
            for (int member : pairing.sets.members(set)) {
                addAllowed(
                        pairing.right.describe(member),
                        inclusion.answers(set, member, failure.alphabet(), failure.letter()),
                        allowed);
            }
        }
        boolean error = failure.sent().error();
        int after = failure.steps().next()[failure.step()];
        return new Forbidden(
                failure.steps().causes().get(failure.step()),
                sent(failure.steps().whole().get(failure.step()), failure.sent()),
                error ? Optional.of(pairing.left.describe(after)) : Optional.empty(),
                before,
                allowed);
    }

    private void addAllowed(String configuration, Steps steps, List<Allowed> allowed) {
        for (int step = 0; step < steps.size(); step++) {
            Map<String, Sent> sent = new LinkedHashMap<>();
            boolean error = !pairing.outputs.isLetter(steps.outputs()[step]);
            Output cube = pairing.outputs.cube(steps.outputs()[step]);
            for (int i = 0; cube != null && i < observed.size(); i++) {
                if (!error || !cube.ports().get(i).equals(Sent.SILENCE)) {
                    sent.put(observed.get(i), cube.ports().get(i));
                }
            }
            allowed.add(new Allowed(configuration, steps.causes().get(step), sent, error));
        }
    }
}
