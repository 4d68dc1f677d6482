package arcomat.analysis.refinement;

import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.refinement.Verdict.Explored;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.Shortcut;
import arcomat.analysis.search.system.RunErrors;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.Promise;
import arcomat.semantics.network.Network;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;

/**
 * Compares two compositions with the same wiring part by part: refining each part refines the whole
 * (the theorem of compositional refinement; time-synchronous only, and without the cases below).
 * The other way round it says nothing.
 */
final class CompositionalRefinement {
    private record Comparison(
            Component left,
            List<Value> leftArguments,
            Component right,
            List<Value> rightArguments) {}

    /** States that are explored before the whole gets its turn, at first. */
    private static final long FEW_STATES = 20_000;

    /** How much more each time. */
    private static final long FACTOR = 16;

    private Budget budget;
    private final Network left;
    private final Network right;
    private final Map<Comparison, Verdict> compared = new HashMap<>();

    private CompositionalRefinement(Promise left, Promise right, Budget budget) {
        this.budget = budget;
        this.left = left.network();
        this.right = right.network();
    }

    /**
     * The verdict if each part refines its namesake; else empty. Where it is hard to say of a part,
     * the whole may have a failure that is soon found: both get more and more to spend, in turns.
     *
     * @param whole compares the whole
     */
    static Optional<Verdict> check(
            Promise left, Promise right, Budget budget, Function<Budget, Verdict> whole) {
        if (!left.isComposition()
                || !right.isComposition()
                || left.component().profile() == Component.Profile.EVENT_DRIVEN) {
            return Optional.empty();
        }
        CompositionalRefinement parts = new CompositionalRefinement(left, right, budget);
        return parts.isSameWiring() && parts.endAlike()
                ? parts.inTurns(budget, whole)
                : Optional.empty();
    }

    private Optional<Verdict> inTurns(Budget most, Function<Budget, Verdict> whole) {
        long states = FEW_STATES;
        while (true) {
            budget = most.atMost(states);
            Answer parts = all();
            if (parts != Answer.UNKNOWN) {
                return parts == Answer.HOLDS && most.takes(Shortcut.PART_BY_PART)
                        ? Optional.of(verdict())
                        : Optional.empty();
            }
            Verdict verdict = whole.apply(budget);
            boolean end = states >= most.states() || most.isSpent();
            if (end || verdict.answer() != Answer.UNKNOWN) {
                return Optional.of(verdict);
            }
            compared.values().removeIf(part -> part.answer() == Answer.UNKNOWN);
            states = states > most.states() / FACTOR ? most.states() : states * FACTOR;
        }
    }

    /** Whether the parts alone tell which runs of the whole end with an error, and with what. */
    private boolean endAlike() {
        return !RunErrors.arePossible(left) || !mayContradict() && showAlikeWhereRunsEnd();
    }

    /**
     * Where one part errs and another one, whose automata contradict each other, allows nothing,
     * the run ends or there is none: that depends on which of them is first.
     */
    private boolean mayContradict() {
        return left.instances().stream().anyMatch(part -> part.component().automata().size() > 1);
    }

    /**
     * Where a run ends, what was sent a slice ago is still seen, and what would be sent now is not.
     * So a part that sends as another one does, but with another delay, makes a difference for the
     * whole if one of its neighbours errs.
     */
    private boolean showAlikeWhereRunsEnd() {
        Set<Integer> mine = left.delayed();
        Set<Integer> theirs = right.delayed();
        Map<String, Integer> signals = signals(left);
        return right.outputs().stream()
                .allMatch(
                        output ->
                                theirs.contains(output.signal())
                                        == mine.contains(signals.get(output.name())));
    }

    private static Map<String, Integer> signals(Network network) {
        Map<String, Integer> outputs = new HashMap<>();
        network.outputs().forEach(output -> outputs.put(output.name(), output.signal()));
        return outputs;
    }

    private boolean isSameWiring() {
        Map<String, Network.Instance> mine = instances(left);
        Map<Integer, String> mySenders = senders(left);
        Map<Integer, String> theirSenders = senders(right);
        if (!mine.keySet().equals(instances(right).keySet())) {
            return false;
        }
        for (Network.Instance theirs : right.instances()) {
            Network.Instance own = Objects.requireNonNull(mine.get(theirs.path()));
            List<Port> inputs = theirs.component().inputs();
            for (int i = 0; i < inputs.size(); i++) {
                int position = position(own.component().inputs(), inputs.get(i).name());
                String sender = theirSenders.get(theirs.inputSignals().get(i));
                if (position < 0
                        || !Objects.equals(
                                sender, mySenders.get(own.inputSignals().get(position)))) {
                    return false;
                }
            }
        }
        Map<String, Integer> outputs = signals(left);
        return right.outputs().stream()
                .allMatch(
                        output ->
                                Objects.equals(
                                        theirSenders.get(output.signal()),
                                        mySenders.get(outputs.get(output.name()))));
    }

    private static int position(List<Port> ports, String name) {
        return ports.stream().map(Port::name).toList().indexOf(name);
    }

    private static Map<String, Network.Instance> instances(Network network) {
        Map<String, Network.Instance> instances = new HashMap<>();
        network.instances().forEach(instance -> instances.put(instance.path(), instance));
        return instances;
    }

    /** Who sends a signal: a port by its path. */
    private static Map<Integer, String> senders(Network network) {
        Map<Integer, String> senders = new HashMap<>();
        network.inputs().forEach(input -> senders.put(input.signal(), input.name()));
        for (Network.Instance instance : network.instances()) {
            List<Port> outputs = instance.component().outputs();
            for (int i = 0; i < outputs.size(); i++) {
                senders.put(
                        instance.outputSignals().get(i),
                        instance.path() + "/" + outputs.get(i).name());
            }
        }
        return senders;
    }

    private Answer all() {
        Answer all = Answer.HOLDS;
        Map<String, Network.Instance> mine = instances(left);
        for (Network.Instance theirs : right.instances()) {
            Network.Instance own = Objects.requireNonNull(mine.get(theirs.path()));
            Comparison comparison =
                    new Comparison(
                            own.component(),
                            own.arguments(),
                            theirs.component(),
                            theirs.arguments());
            Verdict verdict = compared.computeIfAbsent(comparison, this::compare);
            all = all.and(verdict.answer());
            if (all == Answer.FAILS) {
                break;
            }
        }
        return all;
    }

    private Verdict compare(Comparison parts) {
        return Refinement.check(
                Promise.of(parts.left, parts.leftArguments),
                Promise.of(parts.right, parts.rightArguments),
                budget);
    }

    private Verdict verdict() {
        List<Explored> explored = compared.values().stream().map(Verdict::explored).toList();
        boolean simulation = compared.values().stream().allMatch(v -> v.simulation().orElse(false));
        String note =
                "shown part by part: %d parts, %d different"
                        .formatted(right.instances().size(), compared.size());
        return Verdict.holds(
                simulation ? Optional.of(true) : Optional.empty(),
                List.of(note),
                Explored.together(explored, Integer::sum));
    }
}
