package arcomat.pipeline.inside;

import arcomat.model.Value;
import arcomat.semantics.automaton.Input;
import arcomat.semantics.network.Network;

import org.jspecify.annotations.Nullable;

import java.util.List;
import java.util.Set;

/** One message at most in a slice; with delay, it is to be seen in the next one. */
final class SliceSignals implements Signals {
    private final Set<Integer> delayed;

    /** Per signal the message that is visible in the slice, or null. */
    private @Nullable Value[] visible;

    /** Per signal with delay the message of the next slice, or null. */
    private @Nullable Value[] registers;

    SliceSignals(Network network) {
        delayed = network.delayed();
        visible = new Value[network.signals()];
        registers = new Value[network.signals()];
    }

    @Override
    public void next() {
        visible = registers;
        registers = new Value[visible.length];
    }

    @Override
    public void read(Network.Instance part, Input input) {
        for (int i = 0; i < part.inputSignals().size(); i++) {
            int signal = part.inputSignals().get(i);
            if (signal != Network.UNCONNECTED) {
                visible[signal] = input.message(i).orElse(null);
            }
        }
    }

    @Override
    public void send(int signal, List<Value> messages) {
        Value message = messages.isEmpty() ? null : messages.get(0);
        (delayed.contains(signal) ? registers : visible)[signal] = message;
    }

    @Override
    public List<Value> shown(int signal) {
        Value message = visible[signal];
        return message == null ? List.of() : List.of(message);
    }
}
