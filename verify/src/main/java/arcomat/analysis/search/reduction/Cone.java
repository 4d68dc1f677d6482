package arcomat.analysis.search.reduction;

import arcomat.model.Automaton;
import arcomat.model.Automaton.AnyMessage;
import arcomat.model.Automaton.Completion;
import arcomat.model.Automaton.Omitted;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.network.Network;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Deque;
import java.util.List;
import java.util.Set;

/**
 * The parts of a time-synchronous network that what is observed depends on: who sends what is
 * observed, who sends what these read, and so on; and who may end a run or keep it from going on,
 * with all that this depends on.
 */
final class Cone {
    private final int[] senders;
    private final BitSet inside = new BitSet();
    private final Deque<Integer> open = new ArrayDeque<>();

    private Cone(Network network) {
        this.senders = new int[network.signals()];
        Arrays.fill(senders, Network.UNCONNECTED);
        for (int part = 0; part < network.instances().size(); part++) {
            for (int signal : network.instances().get(part).outputSignals()) {
                senders[signal] = part;
            }
        }
    }

    /**
     * Positions of these parts.
     *
     * @param observed signals
     */
    static BitSet of(Network network, int[] observed) {
        Cone cone = new Cone(network);
        for (int signal : observed) {
            cone.addSender(signal);
        }
        for (int part = 0; part < network.instances().size(); part++) {
            if (!alwaysGoesOn(network.instances().get(part).component())) {
                cone.add(part);
            }
        }
        while (!cone.open.isEmpty()) {
            network.instances().get(cone.open.remove()).inputSignals().forEach(cone::addSender);
        }
        return cone.inside;
    }

    private void addSender(int signal) {
        if (signal != Network.UNCONNECTED && senders[signal] != Network.UNCONNECTED) {
            add(senders[signal]);
        }
    }

    private void add(int part) {
        if (!inside.get(part)) {
            inside.set(part);
            open.add(part);
        }
    }

    /**
     * Whether there is a beginning, and a reaction to each input in each configuration, with
     * certain messages, and no other end. An automaton may have to ignore an input for that, so
     * chaos and errors are out; two automata may contradict each other; of none nobody knows.
     */
    static boolean alwaysGoesOn(Component part) {
        if (part.platform()
                || !(part.body() instanceof Component.Atomic atomic)
                || atomic.automata().size() != 1) {
            return false;
        }
        Automaton automaton = atomic.automata().get(0);
        Set<String> written = ComponentSemantics.written(automaton);
        return automaton.completion() == Completion.IGNORE
                && automaton.omitted() == Omitted.SILENT
                && !automaton.initials().isEmpty()
                && part.outputs().stream().allMatch(p -> isDecided(p, written))
                && automaton.initials().stream().allMatch(i -> isSure(i.sends(), i.assignments()))
                && automaton.transitions().stream().allMatch(Cone::isSure);
    }

    private static boolean isDecided(Port port, Set<String> written) {
        return !port.total() || written.contains(port.name());
    }

    private static boolean isSure(Automaton.Transition transition) {
        return SureResults.isSureCondition(transition)
                && isSure(transition.sends(), transition.assignments());
    }

    private static boolean isSure(
            List<Automaton.Send> sends, List<Automaton.Assignment> assignments) {
        return sends.stream().allMatch(Cone::isSure)
                && assignments.stream()
                        .allMatch(a -> SureResults.isSure(a.value(), a.variable().type()));
    }

    private static boolean isSure(Automaton.Send send) {
        return !(send.emission() instanceof AnyMessage)
                && send.emission().values().stream()
                        .allMatch(value -> SureResults.isSure(value, send.port().type()));
    }
}
