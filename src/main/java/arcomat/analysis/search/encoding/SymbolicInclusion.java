package arcomat.analysis.search.encoding;

import arcomat.analysis.search.Budget;
import arcomat.analysis.search.letter.Letters;
import arcomat.analysis.search.packed.NetworkTables;
import arcomat.analysis.search.packed.NetworkTables.TooLarge;
import arcomat.analysis.search.packed.PackedNetwork.CannotPack;
import arcomat.analysis.search.step.OutputCubes;
import arcomat.analysis.search.step.Steps;
import arcomat.analysis.search.system.NetworkSystem;
import arcomat.analysis.search.system.TransitionSystem;
import arcomat.analysis.symbolic.Clauses;
import arcomat.analysis.symbolic.InductiveInvariant;
import arcomat.analysis.symbolic.PropertyDirectedReachability;
import arcomat.analysis.symbolic.PropertyDirectedReachability.Progress;
import arcomat.analysis.symbolic.TransitionRelation;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.value.GivenUp;
import arcomat.semantics.value.SmallType;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * Whether every trace of a network is one of the right side, without looking at configurations one
 * by one. Says only that it holds, by an inductive invariant that has been checked, or nothing.
 */
public final class SymbolicInclusion {
    private static final int MOST_VALUES = 64;
    private static final int MOST_RULES = 20_000;
    private static final int MOST_STARTS = 1_000;

    private final TransitionRelation relation;
    private final InductiveInvariant.Search search;
    private final Budget budget;
    private Progress progress = Progress.WORKS;

    SymbolicInclusion(
            TransitionRelation relation, InductiveInvariant.Search search, Budget budget) {
        this.relation = relation;
        this.search = search;
        this.budget = budget;
    }

    /** Ready to be asked; empty where the question is none for it. */
    public static Optional<SymbolicInclusion> of(
            NetworkSystem left, TransitionSystem right, OutputCubes outputs, Budget budget) {
        try {
            return relation(left, right, outputs).map(relation -> searched(relation, budget));
        } catch (CannotPack | TooLarge unfit) {
            return Optional.empty();
        } catch (GivenUp tooMuch) { // perhaps in what no run ever meets
            budget.insist();
            return Optional.empty();
        }
    }

    private static SymbolicInclusion searched(TransitionRelation relation, Budget budget) {
        return new SymbolicInclusion(
                relation, new PropertyDirectedReachability(relation, budget::insist), budget);
    }

    private static Optional<TransitionRelation> relation(
            NetworkSystem left, TransitionSystem right, OutputCubes outputs) {
        List<List<@Nullable Value>> messages = new ArrayList<>();
        for (Port port : Letters.compared(left.inputs(), right.inputs())) {
            Optional<List<Value>> values = SmallType.values(port.type());
            if (values.isEmpty() || values.get().size() > MOST_VALUES) {
                return Optional.empty();
            }
            List<@Nullable Value> all = new ArrayList<>();
            if (!port.total()) {
                all.add(null);
            }
            all.addAll(values.get());
            messages.add(all);
        }
        Steps openings = left.openings();
        if (openings.size() > MOST_STARTS) {
            return Optional.empty();
        }
        NetworkTables tables = left.tables(messages, openings.next(), MOST_VALUES, MOST_RULES);
        Clauses clauses = new Clauses();
        NetworkBits network = new NetworkBits(tables, clauses);
        List<String> names = left.inputs().stream().map(Port::name).toList();
        int[] inputs =
                right.inputs().stream()
                        .mapToInt(port -> left.inputSignals()[names.indexOf(port.name())])
                        .toArray();
        AnswerBits answers =
                new AnswerBits(
                        right, outputs, tables, network, clauses, inputs, left.outputSignals());
        answers.write();
        List<boolean[]> initial = new ArrayList<>();
        for (int i = 0; i < openings.size(); i++) {
            boolean[] theirs = answers.truths(openings.outputs()[i]);
            if (IntStream.range(0, theirs.length).noneMatch(each -> theirs[each])) {
                return Optional.empty();
            }
            initial.add(joined(network.truths(tables.initial().get(i)), theirs));
        }
        boolean[] alternative = new boolean[network.state().length];
        Arrays.fill(alternative, true);
        return Optional.of(
                new TransitionRelation(
                        clauses,
                        joined(network.state(), answers.state()),
                        joined(network.next(), answers.next()),
                        joined(alternative, new boolean[answers.state().length]),
                        network.inputs(),
                        -network.end(),
                        answers.fails(),
                        initial));
    }

    private static int[] joined(int[] one, int[] other) {
        return IntStream.concat(IntStream.of(one), IntStream.of(other)).toArray();
    }

    private static boolean[] joined(boolean[] one, boolean[] other) {
        boolean[] both = Arrays.copyOf(one, one.length + other.length);
        System.arraycopy(other, 0, both, one.length, other.length);
        return both;
    }

    /** Works on for so long; what has been proved has been checked as well. */
    public Progress work(long amount) {
        if (progress == Progress.WORKS) {
            progress = search.work(amount);
            if (progress == Progress.PROVED && !isProved()) {
                progress = Progress.HOPELESS;
            }
        }
        return progress;
    }

    /** Of how many clauses the invariant is that was found; 0 where none was. */
    public int clauses() {
        return search.invariant().map(found -> found.excluded().size()).orElse(0);
    }

    private boolean isProved() {
        Optional<InductiveInvariant> invariant = search.invariant();
        return invariant.isPresent() && invariant.get().proves(relation, budget::insist);
    }
}
