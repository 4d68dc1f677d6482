package arcomat.simulate.test;

import arcomat.model.Port;
import arcomat.model.StreamTest;
import arcomat.model.Value;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.network.Network;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/**
 * What a test expects in one slice, signal by signal. A message that the model leaves open is what
 * is expected, for everybody who receives it.
 */
final class Expected {
    /** No port is looked at. */
    static final Expected NOTHING = new Expected();

    private final Map<Integer, List<List<Value>>> messages = new HashMap<>();

    private Expected() {}

    /** What is expected on one output. */
    static Expected on(int signal, List<Value> expected) {
        Expected one = new Expected();
        one.add(signal, expected);
        return one;
    }

    /**
     * What is expected on all outputs.
     *
     * @param evaluated whether the slice is gone through, so that ports with delay 0 show something
     */
    static Expected in(int slice, StreamTest test, Wires wires, boolean evaluated) {
        Expected all = new Expected();
        test.expected()
                .forEach(
                        (port, stream) -> {
                            if (isJudged(port, slice, test, wires, evaluated)) {
                                all.add(wires.output(port), stream.get(slice));
                            }
                        });
        return all;
    }

    /** Whether a test says something about a port in a slice. */
    static boolean isJudged(
            String port, int slice, StreamTest test, Wires wires, boolean evaluated) {
        int signal = wires.output(port);
        boolean delayed = signal != Network.UNCONNECTED && wires.isDelayed(signal);
        return slice < Objects.requireNonNull(test.expected().get(port)).size()
                && (evaluated || delayed);
    }

    private void add(int signal, List<Value> expected) {
        messages.computeIfAbsent(signal, key -> new ArrayList<>(1)).add(expected);
    }

    /**
     * What is left of a message: the expected one, if that is allowed.
     *
     * @param sender the port that sends it; null where a port has no sender
     */
    Optional<Sent> settle(int signal, Sent sent, @Nullable Port sender) {
        Sent left = sent;
        for (List<Value> expected : messages.getOrDefault(signal, List.of())) {
            if (!left.allows(expected)) {
                return Optional.empty();
            }
            if (!(left instanceof Sent.Messages)) {
                // An output of the whole may have a wider range than the port that feeds it.
                if (!expected.stream()
                        .allMatch(value -> Objects.requireNonNull(sender).type().has(value))) {
                    return Optional.empty();
                }
                left = new Sent.Messages(expected);
            }
        }
        return Optional.of(left);
    }
}
