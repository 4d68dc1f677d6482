package arcomat.analysis.search.encoding;

import arcomat.analysis.search.packed.NetworkTables;
import arcomat.analysis.search.packed.NetworkTables.PartTable;
import arcomat.analysis.search.packed.NetworkTables.Rule;
import arcomat.analysis.search.packed.NetworkTables.Way;
import arcomat.analysis.symbolic.Clauses;

import com.carrotsearch.hppc.IntArrayList;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;

/**
 * A slice of a network in clauses. What a part is in, and what is on a signal, is one of some
 * variables; where a part has a choice, further variables choose, so that state, inputs and choices
 * have one outcome.
 */
final class NetworkBits {
    /** Some messages of a signal. */
    private record Kind(int signal, List<Integer> messages) {}

    private final NetworkTables tables;
    private final Clauses clauses;

    /** By part. */
    private final int[][] before;

    private final int[][] after;

    /** By signal what was sent a slice ago, of those that are kept. */
    private final int[][] kept;

    /** By signal what is sent in the slice, or comes from outside. */
    private final int[][] sent;

    private final List<int[]> choices = new ArrayList<>();
    private final Map<Kind, Integer> kinds = new HashMap<>();
    private final int end;

    NetworkBits(NetworkTables tables, Clauses clauses) {
        this.tables = tables;
        this.clauses = clauses;
        int parts = tables.parts().size();
        int signals = tables.messages().size();
        before = new int[parts][];
        after = new int[parts][];
        kept = new int[signals][0];
        sent = new int[signals][0];
        for (int part = 0; part < parts; part++) {
            before[part] = clauses.oneOf(tables.parts().get(part).configurations());
            after[part] = clauses.oneOf(tables.parts().get(part).configurations());
        }
        for (int signal = 0; signal < signals; signal++) {
            int count = tables.messages().get(signal).size();
            kept[signal] = tables.kept()[signal] ? clauses.oneOf(count) : new int[0];
            sent[signal] = count > 0 ? clauses.oneOf(count) : new int[0];
        }
        List<Integer> ends = new ArrayList<>();
        for (int part = 0; part < parts; part++) {
            write(part, ends);
        }
        int none = -clauses.truth();
        end =
                ends.isEmpty()
                        ? none
                        : clauses.or(ends.stream().mapToInt(Integer::intValue).toArray());
    }

    /** True where the run ends. */
    int end() {
        return end;
    }

    /** By signal, what is sent in the slice or comes from outside: a variable by message. */
    int[] sent(int signal) {
        return sent[signal];
    }

    /** Variables of the state before; those of one thing are neighbours. */
    int[] state() {
        return IntStream.concat(flat(before), flat(kept)).toArray();
    }

    /** Those of the state afterwards, in the same order. */
    int[] next() {
        int[][] later = new int[kept.length][];
        for (int signal = 0; signal < later.length; signal++) {
            later[signal] = tables.kept()[signal] ? sent[signal] : new int[0];
        }
        return IntStream.concat(flat(after), flat(later)).toArray();
    }

    /** What comes from outside, and the choices. */
    int[] inputs() {
        int[][] outside = new int[sent.length][];
        for (int signal = 0; signal < outside.length; signal++) {
            outside[signal] = tables.external()[signal] ? sent[signal] : new int[0];
        }
        return IntStream.concat(flat(outside), choices.stream().flatMapToInt(Arrays::stream))
                .toArray();
    }

    private static IntStream flat(int[][] variables) {
        return Arrays.stream(variables).flatMapToInt(Arrays::stream);
    }

    /** Where a run begins, variable by variable. */
    boolean[] truths(NetworkTables.Start start) {
        boolean[] truths = new boolean[state().length];
        int from = 0;
        for (int part = 0; part < before.length; part++) {
            truths[from + start.configurations()[part]] = true;
            from += before[part].length;
        }
        for (int signal = 0; signal < kept.length; signal++) {
            if (kept[signal].length > 0) {
                truths[from + start.kept()[signal]] = true;
                from += kept[signal].length;
            }
        }
        return truths;
    }

    /** True where one of some messages is on a signal, as variables tell of it. */
    private int kind(int signal, int[] variables, int[] messages) {
        Kind kind = new Kind(signal, IntStream.of(messages).boxed().toList());
        return kinds.computeIfAbsent(
                kind, each -> clauses.or(IntStream.of(messages).map(i -> variables[i]).toArray()));
    }

    /**
     * @param ends literals that are true where a part ends the run
     */
    private void write(int part, List<Integer> ends) {
        PartTable table = tables.parts().get(part);
        int most = table.rules().stream().mapToInt(rule -> rule.ways().size()).max().orElse(1);
        int[] choice = IntStream.range(1, most).map(i -> clauses.variable()).toArray();
        choices.add(choice);
        boolean mayEnd =
                table.rules().stream().anyMatch(rule -> rule.ways().stream().anyMatch(Way::ends));
        int ended = mayEnd ? clauses.variable() : -clauses.truth();
        if (mayEnd) {
            ends.add(ended);
        }
        boolean[] goesOn = new boolean[table.configurations()];
        for (Rule rule : table.rules()) {
            goesOn[rule.configuration()] = true;
            write(part, rule, choice, ended);
        }
        for (int configuration = 0; configuration < goesOn.length; configuration++) {
            if (!goesOn[configuration]) {
                clauses.add(-before[part][configuration]); // that of a run that has ended
            }
        }
    }

    private void write(int part, Rule rule, int[] choice, int ended) {
        PartTable table = tables.parts().get(part);
        IntArrayList unless = new IntArrayList();
        unless.add(-before[part][rule.configuration()]);
        for (int port = 0; port < table.inputs().length; port++) {
            int[] messages = rule.read()[port];
            int signal = table.inputs()[port];
            if (messages != null && signal >= 0) {
                int[] variables = tables.kept()[signal] ? kept[signal] : sent[signal];
                unless.add(-kind(signal, variables, messages));
            }
        }
        int ways = rule.ways().size();
        for (int way = 0; way < ways; way++) {
            IntArrayList premise = new IntArrayList(unless);
            for (int earlier = 0; earlier < way; earlier++) {
                premise.add(choice[earlier]);
            }
            if (way < ways - 1) {
                premise.add(-choice[way]);
            }
            follow(part, rule.ways().get(way), premise, ended);
        }
    }

    private void follow(int part, Way way, IntArrayList unless, int ended) {
        if (way.ends()) {
            imply(unless, ended);
            return;
        }
        imply(unless, -ended);
        imply(unless, after[part][way.next()]);
        int[] outputs = tables.parts().get(part).outputs();
        for (int port = 0; port < outputs.length; port++) {
            imply(unless, sent[outputs[port]][way.sent()[port]]);
        }
    }

    private void imply(IntArrayList unless, int literal) {
        int[] clause = Arrays.copyOf(unless.toArray(), unless.size() + 1);
        clause[unless.size()] = literal;
        clauses.add(clause);
    }
}
