package arcomat.analysis.search.packed;

import arcomat.analysis.search.composition.GlobalState;
import arcomat.analysis.search.packed.PackedNetwork.CannotPack;
import arcomat.model.Value;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.network.Network;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;

/**
 * All that the parts of a network may do, whatever they read of what others may send: their tables,
 * closed. There may be more in them than a run can meet, never less.
 *
 * @param parts in the order of a slice
 * @param messages per signal what may be on it, by number
 * @param kept per signal, whether a configuration has what was sent a slice ago
 * @param external signals that come from outside
 * @param observed signals that compared outputs show
 * @param initial where a run may begin
 */
public record NetworkTables(
        List<PartTable> parts,
        List<List<Sent>> messages,
        boolean[] kept,
        boolean[] external,
        int[] observed,
        List<Start> initial) {
    public NetworkTables {
        messages = List.copyOf(messages);
    }

    /**
     * What a part may do.
     *
     * @param where its configurations, by number
     * @param inputs signals by port; -1 where nothing is connected
     * @param outputs signals by port
     * @param delayed by output port, whether it is read a slice later
     */
    public record PartTable(
            List<List<Configuration>> where,
            int[] inputs,
            int[] outputs,
            boolean[] delayed,
            List<Rule> rules) {
        /** How many there are. */
        public int configurations() {
            return where.size();
        }
    }

    /**
     * What a part does in a configuration, with messages that it does not tell apart.
     *
     * @param read by input port the numbers of these messages; null where it may be any
     * @param ways what it may do
     */
    public record Rule(int configuration, int[] @Nullable [] read, List<Way> ways) {}

    /**
     * A way to react.
     *
     * @param next the configuration afterwards; -1 where the run ends
     * @param sent by output port
     */
    public record Way(int next, int[] sent) {
        /** Whether the run ends. */
        public boolean ends() {
            return next == PartOutcomes.END;
        }
    }

    /**
     * Where a run begins.
     *
     * @param configurations of the parts
     * @param kept what is on signals; of those that are kept
     */
    public record Start(int[] configurations, int[] kept) {}

    /** There is more than can be told like this. */
    public static final class TooLarge extends RuntimeException {
        private static final long serialVersionUID = 1L;

        public TooLarge() {
            super("too large for tables", null, false, false);
        }
    }

    /**
     * @param inputs by external input the messages that may come
     * @param starts where runs begin
     * @param most how many configurations of a part, and messages on a signal, there may be
     * @param rules how many rules there may be in all
     */
    public static NetworkTables of(
            SliceNetwork network,
            List<List<@Nullable Value>> inputs,
            List<GlobalState> starts,
            int most,
            int rules) {
        for (int input = 0; input < inputs.size(); input++) {
            for (Value message : inputs.get(input)) {
                network.external(input, message);
            }
        }
        boolean[] kept = new boolean[network.signalField.length];
        for (int signal = 0; signal < kept.length; signal++) {
            kept[signal] = network.signalField[signal] >= 0;
        }
        List<Start> initial = starts.stream().map(state -> start(network, state)).toList();
        Closure closure = new Closure(network, most, rules);
        closure.close();
        List<PartTable> tables = new ArrayList<>();
        for (int part = 0; part < network.parts.size(); part++) {
            tables.add(closure.table(part));
        }
        List<List<Sent>> messages = new ArrayList<>();
        boolean[] external = new boolean[kept.length];
        for (int signal = 0; signal < kept.length; signal++) {
            List<Sent> all = new ArrayList<>();
            for (int i = 0; i < network.messages.get(signal).size(); i++) {
                all.add(network.messages.get(signal).get(i));
            }
            messages.add(List.copyOf(all));
            external[signal] = network.isExternal(signal);
        }
        return new NetworkTables(tables, messages, kept, external, network.observed, initial);
    }

    private static Start start(SliceNetwork network, GlobalState state) {
        int[] configurations = new int[network.parts.size()];
        for (int part = 0; part < configurations.length; part++) {
            configurations[part] = network.parts.get(part).number(state.parts().get(part));
        }
        int[] kept = new int[network.signalField.length];
        for (int signal = 0; signal < kept.length; signal++) {
            if (network.signalField[signal] >= 0) {
                kept[signal] = network.number(signal, state.registers().get(signal));
            }
        }
        return new Start(configurations, kept);
    }

    /** Asks parts about all that they may read, until they send and reach nothing new. */
    private static final class Closure {
        private final SliceNetwork network;
        private final int most;
        private final int mostRules;
        private boolean grows = true;
        private int count;

        Closure(SliceNetwork network, int most, int mostRules) {
            this.network = network;
            this.most = most;
            this.mostRules = mostRules;
        }

        void close() {
            int before;
            int met = -1;
            do {
                before = met;
                met = 0;
                count = 0;
                for (int part = 0; part < network.parts.size(); part++) {
                    rules(part);
                    met += met(part);
                }
            } while (met != before);
            grows = false;
            count = 0;
        }

        /** What has been met in a part and on what it sends, counted. */
        private int met(int part) {
            int count = network.parts.get(part).size();
            for (int signal : network.network.instances().get(part).outputSignals()) {
                int messages = network.messages.get(signal).size();
                for (int i = 0; i < messages; i++) {
                    network.refuseOpen(signal, i);
                }
                count += messages;
                if (messages > most) {
                    throw new TooLarge();
                }
            }
            if (network.parts.get(part).size() > most) {
                throw new TooLarge();
            }
            return count;
        }

        PartTable table(int part) {
            Network.Instance instance = network.network.instances().get(part);
            int[] outputs = ints(instance.outputSignals());
            boolean[] delayed = new boolean[outputs.length];
            for (int port = 0; port < outputs.length; port++) {
                delayed[port] = network.delayed[outputs[port]];
            }
            PartOutcomes outcomes = network.parts.get(part);
            return new PartTable(
                    IntStream.range(0, outcomes.size()).mapToObj(outcomes::configuration).toList(),
                    ints(instance.inputSignals()),
                    outputs,
                    delayed,
                    rules(part));
        }

        private static int[] ints(List<Integer> signals) {
            return signals.stream().mapToInt(Integer::intValue).toArray();
        }

        private List<Rule> rules(int part) {
            List<Rule> rules = new ArrayList<>();
            PartOutcomes outcomes = network.parts.get(part);
            for (int configuration = 0; configuration < outcomes.size(); configuration++) {
                List<Configuration> where = outcomes.configuration(configuration);
                if (!where.contains(Configuration.ERROR)) {
                    rules(part, configuration, rules);
                } else if (where.size() > 1) {
                    throw new CannotPack("a part goes on beside an error");
                }
            }
            return rules;
        }

        private void rules(int part, int configuration, List<Rule> rules) {
            PartOutcomes outcomes = network.parts.get(part);
            Network.Instance instance = network.network.instances().get(part);
            int ports = instance.inputSignals().size();
            int[][][] kinds = new int[ports][][];
            for (int port = 0; port < ports; port++) {
                kinds[port] =
                        kinds(outcomes, configuration, port, instance.inputSignals().get(port));
            }
            if (Arrays.stream(kinds).anyMatch(each -> each.length == 0)) {
                if (grows) {
                    return; // nobody has been asked yet what is sent there
                }
                throw new CannotPack("nothing is ever sent that a part reads");
            }
            int[] which = new int[ports];
            do {
                if (++count > mostRules) {
                    throw new TooLarge();
                }
                rules.add(rule(part, configuration, kinds, which));
            } while (next(which, kinds));
        }

        private static boolean next(int[] which, int[][][] kinds) {
            for (int port = 0; port < which.length; port++) {
                if (++which[port] < kinds[port].length) {
                    return true;
                }
                which[port] = 0;
            }
            return false;
        }

        private Rule rule(int part, int configuration, int[][][] kinds, int[] which) {
            Network.Instance instance = network.network.instances().get(part);
            int[] messages = new int[which.length];
            int[][] read = new int[which.length][];
            for (int port = 0; port < which.length; port++) {
                boolean connected = instance.inputSignals().get(port) >= 0;
                int[] kind = kinds[port][which[port]];
                messages[port] = connected ? kind[0] : -1;
                read[port] = kinds[port].length == 1 ? null : kind;
            }
            int[] row = network.parts.get(part).row(configuration, messages).numbers();
            int stride = 1 + instance.outputSignals().size();
            List<Way> ways = new ArrayList<>();
            for (int from = 0; from < row.length; from += stride) {
                ways.add(new Way(row[from], Arrays.copyOfRange(row, from + 1, from + stride)));
            }
            if (ways.isEmpty()) {
                throw new CannotPack("a part stands still");
            }
            return new Rule(configuration, read, ways);
        }

        /** Messages that are not told apart on a port, kind by kind. */
        private int[][] kinds(PartOutcomes outcomes, int configuration, int port, int signal) {
            if (signal < 0) {
                return new int[][] {{0}};
            }
            List<List<Integer>> kinds = new ArrayList<>();
            for (int message = 0; message < network.messages.get(signal).size(); message++) {
                int kind = outcomes.kind(configuration, port, message);
                while (kinds.size() <= kind) {
                    kinds.add(new ArrayList<>());
                }
                kinds.get(kind).add(message);
            }
            return kinds.stream().map(Closure::ints).toArray(int[][]::new);
        }
    }
}
