package arcomat.analysis.search.product;

import arcomat.analysis.search.Moment;
import arcomat.analysis.search.letter.Alphabet;
import arcomat.analysis.search.step.CubeSplit;
import arcomat.analysis.search.step.Steps;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.semantics.expression.Output;
import arcomat.semantics.expression.Sent;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/**
 * A shortest run of the left side that the right side forbids.
 *
 * @param moments its steps, the forbidden one included; the beginning first
 * @param forbidden its last step, from both sides
 */
public record Counterexample(List<Moment> moments, Forbidden forbidden) {

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

    /** Tells what a search has found: steps between its pairs are found again. */
    static final class Teller {
        private final Product product;
        private final Antichain pairs;
        private final List<String> observed;

        Teller(Product product, Antichain pairs) {
            this.product = product;
            this.pairs = pairs;
            this.observed = product.observed.stream().map(Port::name).toList();
        }

        Counterexample tell(TraceInclusion.Failure failure) {
            return new Counterexample(moments(failure), forbidden(failure));
        }

        private List<Moment> moments(TraceInclusion.Failure failure) {
            List<Moment> moments = new ArrayList<>();
            int before = Antichain.NONE;
            for (int node : pairs.path(failure.node())) {
                moments.add(between(before, node));
                before = node;
            }
            Value[] letter =
                    before == Antichain.NONE
                            ? null
                            : Objects.requireNonNull(failure.alphabet()).letter(failure.letter());
            moments.add(moment(letter, failure.steps(), failure.step(), failure.sent(), List.of()));
            return moments;
        }

        /** The step between two pairs, or to a beginning, found again. */
        private Moment between(int before, int after) {
            if (before == Antichain.NONE) {
                Steps theirs = product.right.openings();
                return step(null, product.left.openings(), theirs, pairs.cost(after), after)
                        .orElseThrow();
            }
            int left = pairs.left(before);
            int set = pairs.set(before);
            Alphabet alphabet = product.alphabet(left, set);
            Steps[] mine = product.leftSteps(left, alphabet);
            int gain = pairs.cost(after) - pairs.cost(before);
            for (int letter = 0; letter < alphabet.size(); letter++) {
                Steps theirs = product.answers(set, alphabet, letter);
                int sent = gain - alphabet.messages(letter);
                Optional<Moment> found =
                        step(alphabet.letter(letter), mine[letter], theirs, sent, after);
                if (found.isPresent()) {
                    return found.get();
                }
            }
            throw new AssertionError("no step between two pairs of a path");
        }

        /** The first step with a letter, and as many messages, that leads to a pair. */
        private Optional<Moment> step(
                Value @Nullable [] letter, Steps mine, Steps theirs, int messages, int after) {
            for (int step = 0; step < mine.size(); step++) {
                if (mine.next()[step] != pairs.left(after)) {
                    continue;
                }
                for (CubeSplit.Case sent : product.cases(mine.outputs()[step], theirs)) {
                    if (sent.allowed().length > 0
                            && sent.messages() == messages
                            && product.successor(theirs, sent.allowed()) == pairs.set(after)) {
                        return Optional.of(moment(letter, mine, step, sent, right(after)));
                    }
                }
            }
            return Optional.empty();
        }

        private List<String> right(int node) {
            return Arrays.stream(product.sets.members(pairs.set(node)))
                    .mapToObj(product.right::describe)
                    .toList();
        }

        private Moment moment(
                Value @Nullable [] letter,
                Steps mine,
                int step,
                CubeSplit.Case sent,
                List<String> right) {
            return new Moment(
                    letter == null ? Letter.SILENCE : Letter.of(product.left.inputs(), letter),
                    sent(mine.whole().get(step), sent),
                    sent.error() ? "error" : product.left.describe(mine.next()[step]),
                    right,
                    sent.error());
        }

        /**
         * On compared ports, and on those that show the same message, the sample; on others what
         * the left side sends there. Where the run ends, only what is still seen.
         */
        private Map<String, Sent> sent(Output whole, CubeSplit.Case sent) {
            Map<String, String> twins = product.left.twins();
            List<Port> outputs = product.left.outputs();
            Map<String, Sent> shown = new LinkedHashMap<>();
            for (int i = 0; i < outputs.size(); i++) {
                String name = outputs.get(i).name();
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

        private Forbidden forbidden(TraceInclusion.Failure failure) {
            List<Allowed> allowed = new ArrayList<>();
            String before = "";
            if (failure.node() == Antichain.NONE) {
                addAllowed("", product.right.openings(), allowed);
            } else {
                before = product.left.describe(pairs.left(failure.node()));
                int set = pairs.set(failure.node());
                Alphabet alphabet = Objects.requireNonNull(failure.alphabet());
                for (int member : product.sets.members(set)) {
                    addAllowed(
                            product.right.describe(member),
                            product.answers(set, member, alphabet, failure.letter()),
                            allowed);
                }
            }
            boolean error = failure.sent().error();
            int after = failure.steps().next()[failure.step()];
            return new Forbidden(
                    failure.steps().causes().get(failure.step()),
                    sent(failure.steps().whole().get(failure.step()), failure.sent()),
                    error ? Optional.of(product.left.describe(after)) : Optional.empty(),
                    before,
                    allowed);
        }

        private void addAllowed(String configuration, Steps steps, List<Allowed> allowed) {
            for (int step = 0; step < steps.size(); step++) {
                Map<String, Sent> sent = new LinkedHashMap<>();
                boolean error = !product.outputs.isLetter(steps.outputs()[step]);
                Output cube = product.outputs.cube(steps.outputs()[step]);
                for (int i = 0; cube != null && i < observed.size(); i++) {
                    if (!error || !cube.ports().get(i).equals(Sent.SILENCE)) {
                        sent.put(observed.get(i), cube.ports().get(i));
                    }
                }
                allowed.add(new Allowed(configuration, steps.causes().get(step), sent, error));
            }
        }
    }
}
