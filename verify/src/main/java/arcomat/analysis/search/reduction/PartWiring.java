package arcomat.analysis.search.reduction;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.semantics.network.Network;
import arcomat.semantics.network.Network.Instance;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** Who sends and reads what in a network, and which of its parts are equal. */
final class PartWiring {

    /** An input port of a part. */
    record Reader(int part, int port) {}

    final Network network;

    /** Signals that have to stay where they are: those that come from outside, or are compared. */
    final int[] fixed;

    /** Per signal the part that sends it; -1 for one from outside. */
    final int[] senders;

    final List<List<Reader>> readers = new ArrayList<>();

    PartWiring(Network network, int[] observed) {
        this.network = network;
        fixed =
                IntStream.concat(
                                Arrays.stream(observed),
                                network.inputs().stream().mapToInt(Network.External::signal))
                        .toArray();
        senders = new int[network.signals()];
        Arrays.fill(senders, -1);
        for (int signal = 0; signal < senders.length; signal++) {
            readers.add(new ArrayList<>());
        }
        for (int part = 0; part < network.instances().size(); part++) {
            for (int signal : outputs(part)) {
                senders[signal] = part;
            }
            for (int port = 0; port < inputs(part).size(); port++) {
                if (inputs(part).get(port) >= 0) {
                    readers.get(inputs(part).get(port)).add(new Reader(part, port));
                }
            }
        }
    }

    List<Integer> inputs(int part) {
        return network.instances().get(part).inputSignals();
    }

    List<Integer> outputs(int part) {
        return network.instances().get(part).outputSignals();
    }

    /** Whether two parts are made of the same component, with the same arguments. */
    boolean areEqual(int part, int other) {
        Instance one = network.instances().get(part);
        Instance two = network.instances().get(other);
        return one.component() == two.component() && one.arguments().equals(two.arguments());
    }

    /** The only part that reads a signal as another one reads its; -1 if there is none, or more. */
    int only(int signal, Reader like) {
        int found = -1;
        for (Reader reader : readers.get(signal)) {
            if (reader.port == like.port && areEqual(reader.part, like.part)) {
                if (found >= 0) {
                    return -1;
                }
                found = reader.part;
            }
        }
        return found;
    }

    /** Whether a part does the same if it reads its signals on other ports. */
    boolean ignoresOrder(int part, List<Integer> moved) {
        List<Integer> own = inputs(part);
        Component component = network.instances().get(part).component();
        List<Port> ports = component.inputs();
        Map<String, String> names = new HashMap<>();
        for (int port = 0; port < own.size(); port++) {
            int other = own.indexOf(moved.get(port));
            if (own.get(port) < 0) {
                other = port;
            }
            boolean twice = own.get(port) >= 0 && own.lastIndexOf(moved.get(port)) != other;
            if (other < 0 || twice || !areAlike(ports.get(port), ports.get(other))) {
                return false;
            }
            names.put(ports.get(port).name(), ports.get(other).name());
        }
        NormalForm before = new NormalForm(name -> name);
        NormalForm after = new NormalForm(name -> names.getOrDefault(name, name));
        return component.automata().stream()
                .allMatch(a -> !mayDivideByZero(a) && before.of(a).equals(after.of(a)));
    }

    private static boolean areAlike(Port one, Port other) {
        return one.type().equals(other.type())
                && one.total() == other.total()
                && one.latched() == other.latched()
                && one.first().equals(other.first());
    }

    private static boolean mayDivideByZero(Automaton automaton) {
        return automaton.transitions().stream()
                .flatMap(PartWiring::expressions)
                .anyMatch(SureResults::mayDivideByZero);
    }

    private static Stream<Expression> expressions(Automaton.Transition transition) {
        return Stream.of(
                        transition.guard().stream(),
                        transition.matches().stream().flatMap(m -> m.pattern().values().stream()),
                        transition.sends().stream().flatMap(s -> s.emission().values().stream()),
                        transition.assignments().stream().map(Automaton.Assignment::value))
                .flatMap(each -> each);
    }
}
