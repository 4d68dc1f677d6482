package arcomat.analysis.search.encoding;

import arcomat.analysis.search.packed.NetworkTables;
import arcomat.analysis.search.step.OutputCubes;
import arcomat.analysis.search.step.Steps;
import arcomat.analysis.search.system.TransitionSystem;
import arcomat.analysis.symbolic.Clauses;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.expression.Output;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.value.InputAbstraction.Compared;
import arcomat.semantics.value.InputAbstraction.PortAbstraction;
import arcomat.semantics.value.InputAbstraction.Unseen;
import arcomat.semantics.value.MessageClasses;

import com.carrotsearch.hppc.IntArrayList;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * What the right side may be in, and how it answers, in clauses: a variable for each of its
 * configurations, true where it may be in it (subset construction).
 */
final class AnswerBits {
    /** So many configurations of the right side are written down, */
    private static final int MOST_CONFIGURATIONS = 256;

    /** .. with so many letters in all. */
    private static final int MOST_LETTERS = 20_000;

    /** An answer, with the configuration that it leads to. */
    private record Answer(int next, int literal) {}

    private final TransitionSystem right;
    private final OutputCubes outputs;
    private final NetworkTables tables;
    private final NetworkBits network;
    private final Clauses clauses;

    /** By input of the right side, and by output that is compared. */
    private final int[] inputs;

    private final int[] shown;

    private final List<Integer> configurations = new ArrayList<>();
    private final List<Integer> before = new ArrayList<>();
    private final List<Answer> answers = new ArrayList<>();
    private final List<Integer> ends = new ArrayList<>();
    private long written;

    /**
     * @param inputs signals of the inputs of the right side
     * @param shown signals of the compared outputs; -1 where nothing is ever sent
     */
    AnswerBits(
            TransitionSystem right,
            OutputCubes outputs,
            NetworkTables tables,
            NetworkBits network,
            Clauses clauses,
            int[] inputs,
            int[] shown) {
        this.right = right;
        this.outputs = outputs;
        this.tables = tables;
        this.network = network;
        this.clauses = clauses;
        this.inputs = inputs;
        this.shown = shown;
    }

    /** Writes down all that the right side may do. */
    void write() {
        for (int next : right.openings().next()) {
            position(next);
        }
        for (int position = 0; position < configurations.size(); position++) {
            answers(position);
        }
    }

    private int position(int configuration) {
        int known = configurations.indexOf(configuration);
        if (known >= 0) {
            return known;
        }
        if (configurations.size() == MOST_CONFIGURATIONS) {
            throw new NetworkTables.TooLarge();
        }
        configurations.add(configuration);
        before.add(clauses.variable());
        return configurations.size() - 1;
    }

    /** Variables of what it may be in before the slice. */
    int[] state() {
        return before.stream().mapToInt(Integer::intValue).toArray();
    }

    /** What they mean. */
    List<String> words() {
        List<String> described = configurations.stream().map(right::describe).toList();
        return IntStream.range(0, described.size())
                .mapToObj(i -> "right may be in " + word(i, described))
                .toList();
    }

    /** With its name where others are described alike. */
    private String word(int position, List<String> described) {
        String own = described.get(position);
        return Collections.frequency(described, own) == 1
                ? own
                : own + " " + right.name(configurations.get(position));
    }

    /** Those for what it may be in afterwards. */
    int[] next() {
        return IntStream.range(0, configurations.size()).map(i -> any(i)).toArray();
    }

    private int any(int position) {
        return or(answers.stream().filter(each -> each.next == position));
    }

    private int or(Stream<Answer> some) {
        int[] literals = some.mapToInt(Answer::literal).toArray();
        int any = clauses.variable();
        int[] longer = Arrays.copyOf(literals, literals.length + 1);
        longer[literals.length] = -any;
        clauses.add(longer);
        for (int literal : literals) {
            clauses.add(-literal, any);
        }
        return any;
    }

    /** True where it cannot follow. */
    int fails() {
        int follows = or(answers.stream());
        int errs = or(ends.stream().map(literal -> new Answer(0, literal)));
        return clauses.or(clauses.and(network.end(), -errs), clauses.and(-network.end(), -follows));
    }

    /** What it may be in after a beginning, variable by variable; none where it forbids that. */
    boolean[] truths(int sent) {
        Steps theirs = right.openings();
        boolean[] truths = new boolean[configurations.size()];
        for (int step = 0; step < theirs.size(); step++) {
            if (outputs.isLetter(sent) && outputs.isLetter(theirs.outputs()[step])) {
                Output mine = outputs.letter(sent);
                Output other = outputs.letter(theirs.outputs()[step]);
                boolean allowed =
                        IntStream.range(0, shown.length)
                                .allMatch(i -> allows(other.ports().get(i), mine.ports().get(i)));
                truths[position(theirs.next()[step])] |= allowed;
            }
        }
        return truths;
    }

    /** Whether all that is left open is allowed; of what is sent for certain, just that. */
    private static boolean allows(Sent allowed, Sent sent) {
        return sent instanceof Sent.Messages messages
                ? allowed.allows(messages.values())
                : allowed instanceof Sent.Anything || allowed.equals(sent);
    }

    private void answers(int position) {
        int configuration = configurations.get(position);
        List<PortAbstraction> looks = right.letterClasses(configuration).abstraction().looks();
        List<List<int[]>> kinds = new ArrayList<>();
        long letters = 1;
        for (int port = 0; port < inputs.length; port++) {
            kinds.add(kinds(right.inputs().get(port), looks.get(port), inputs[port]));
            letters *= kinds.get(port).size();
            if (written + letters > MOST_LETTERS) {
                throw new NetworkTables.TooLarge();
            }
        }
        written += letters;
        for (long letter = 0; letter < letters; letter++) {
            answers(position, kinds, letter);
        }
    }

    /** Messages on an input that are not told apart, kind by kind. */
    private List<int[]> kinds(Port port, PortAbstraction look, int signal) {
        List<Sent> messages = tables.messages().get(signal);
        boolean coarse = look instanceof Unseen || look instanceof Compared;
        Map<Integer, IntArrayList> kinds = new TreeMap<>();
        for (int i = 0; i < messages.size(); i++) {
            int kind = coarse ? MessageClasses.of(port, false, look).of(value(messages.get(i))) : i;
            kinds.computeIfAbsent(kind, each -> new IntArrayList()).add(i);
        }
        return kinds.values().stream().map(IntArrayList::toArray).toList();
    }

    private static @Nullable Value value(Sent sent) {
        List<Value> values = ((Sent.Messages) sent).values();
        return values.isEmpty() ? null : values.get(0);
    }

    private void answers(int position, List<List<int[]>> kinds, long letter) {
        IntArrayList premise = new IntArrayList();
        premise.add(before.get(position));
        @Nullable Value[] own = new Value[inputs.length];
        long rest = letter;
        for (int port = 0; port < inputs.length; port++) {
            int count = kinds.get(port).size();
            int[] kind = kinds.get(port).get((int) (rest % count));
            rest /= count;
            own[port] = value(tables.messages().get(inputs[port]).get(kind[0]));
            if (count > 1) {
                premise.add(one(inputs[port], kind));
            }
        }
        Steps steps = right.steps(configurations.get(position), own);
        for (int step = 0; step < steps.size(); step++) {
            answer(premise, steps.outputs()[step], steps.next()[step]);
        }
    }

    private int one(int signal, int[] messages) {
        int[] variables = network.sent(signal);
        return clauses.or(IntStream.of(messages).map(i -> variables[i]).toArray());
    }

    private void answer(IntArrayList premise, int output, int next) {
        IntArrayList all = new IntArrayList(premise);
        Output cube = outputs.cube(output);
        for (int i = 0; i < shown.length; i++) {
            Sent allowed = cube == null ? Sent.SILENCE : cube.ports().get(i);
            if (!outputs.isLetter(output) || shown[i] < 0) {
                if (!allowed.allows(List.of())) {
                    return;
                }
            } else if (!restrict(all, allowed, shown[i])) {
                return;
            }
        }
        if (outputs.isLetter(output)) {
            all.add(-network.end());
            answers.add(new Answer(position(next), clauses.and(all.toArray())));
        } else {
            ends.add(clauses.and(all.toArray()));
        }
    }

    /** Whether some message on a signal is allowed; adds what says that it is. */
    private boolean restrict(IntArrayList all, Sent allowed, int signal) {
        List<Sent> messages = tables.messages().get(signal);
        int[] possible =
                IntStream.range(0, messages.size())
                        .filter(i -> allows(allowed, messages.get(i)))
                        .toArray();
        if (possible.length > 0 && possible.length < messages.size()) {
            all.add(one(signal, possible));
        }
        return possible.length > 0;
    }
}
