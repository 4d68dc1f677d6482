package arcomat.analysis.search.encoding;

import arcomat.analysis.search.letter.Letters;
import arcomat.analysis.search.packed.NetworkTables;
import arcomat.analysis.search.packed.NetworkTables.TooLarge;
import arcomat.analysis.search.packed.PackedNetwork.CannotPack;
import arcomat.analysis.search.step.OutputCubes;
import arcomat.analysis.search.step.Steps;
import arcomat.analysis.search.system.NetworkSystem;
import arcomat.analysis.search.system.NetworkWords;
import arcomat.analysis.search.system.TransitionSystem;
import arcomat.analysis.symbolic.Clauses;
import arcomat.analysis.symbolic.TransitionRelation;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.value.GivenUp;
import arcomat.semantics.value.SmallType;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.IntStream;

/**
 * A network beside the right side, in bits. A step is bad where the right side cannot follow.
 *
 * @param words what the bits mean, found out where somebody asks: most proofs are never written
 * @param granted cubes that an invariant excludes without saying it; they are checked like others
 */
public record InclusionBits(
        TransitionRelation relation, Supplier<StateWords> words, List<int[]> granted) {
    public InclusionBits {
        granted = List.copyOf(granted);
    }

    private static final int MOST_VALUES = 64;
    private static final int MOST_RULES = 20_000;
    private static final int MOST_STARTS = 1_000;

    /**
     * @throws CannotPack where it cannot be told in bits
     * @throws TooLarge where that were too many
     * @throws GivenUp where something that a part might meet is too much
     */
    public static InclusionBits of(
            NetworkSystem left, TransitionSystem right, OutputCubes outputs) {
        Steps openings = left.openings();
        if (openings.size() > MOST_STARTS) {
            throw new CannotPack("it may begin in more than %d ways".formatted(MOST_STARTS));
        }
        NetworkTables tables =
                left.tables(messages(left, right), openings.next(), MOST_VALUES, MOST_RULES);
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
                throw new CannotPack("a beginning is forbidden");
            }
            initial.add(joined(network.truths(tables.initial().get(i)), theirs));
        }
        boolean[] alternative = new boolean[network.state().length];
        Arrays.fill(alternative, true);
        TransitionRelation relation =
                new TransitionRelation(
                        clauses,
                        joined(network.state(), answers.state()),
                        joined(network.next(), answers.next()),
                        joined(alternative, new boolean[answers.state().length]),
                        network.inputs(),
                        -network.end(),
                        answers.fails(),
                        initial);
        List<int[]> granted =
                answers.state().length == 1
                        ? List.of(new int[] {-relation.state().length})
                        : List.of();
        return new InclusionBits(relation, () -> words(tables, left.words(), answers), granted);
    }

    /** By input what may come. */
    private static List<List<@Nullable Value>> messages(
            NetworkSystem left, TransitionSystem right) {
        List<List<@Nullable Value>> messages = new ArrayList<>();
        for (Port port : Letters.compared(left.inputs(), right.inputs())) {
            Optional<List<Value>> values = SmallType.values(port.type());
            if (values.isEmpty() || values.get().size() > MOST_VALUES) {
                throw new CannotPack(
                        "input '%s' has more than %d values".formatted(port.name(), MOST_VALUES));
            }
            List<@Nullable Value> all = new ArrayList<>();
            if (!port.total()) {
                all.add(null);
            }
            all.addAll(values.get());
            messages.add(all);
        }
        return messages;
    }

    /** In the order of the bits. */
    private static StateWords words(NetworkTables tables, NetworkWords words, AnswerBits answers) {
        StateWords.Collector all = new StateWords.Collector();
        for (int part = 0; part < tables.parts().size(); part++) {
            int which = part;
            List<List<Configuration>> where = tables.parts().get(part).where();
            all.alternatives(
                    where.stream().map(each -> words.part(which, each)).toList(),
                    where.stream().map(each -> !each.contains(Configuration.ERROR)).toList());
        }
        List<String> inputs = new ArrayList<>();
        for (int signal = 0; signal < tables.messages().size(); signal++) {
            int which = signal;
            List<String> messages =
                    tables.messages().get(signal).stream()
                            .map(message -> words.signal(which, message))
                            .toList();
            if (tables.kept()[signal]) {
                all.alternatives(messages, messages.stream().map(each -> true).toList());
            }
            if (tables.external()[signal]) {
                inputs.addAll(messages);
            }
        }
        all.each(answers.words());
        return all.words(inputs);
    }

    private static int[] joined(int[] one, int[] other) {
        return IntStream.concat(IntStream.of(one), IntStream.of(other)).toArray();
    }

    private static boolean[] joined(boolean[] one, boolean[] other) {
        boolean[] both = Arrays.copyOf(one, one.length + other.length);
        System.arraycopy(other, 0, both, one.length, other.length);
        return both;
    }
}
