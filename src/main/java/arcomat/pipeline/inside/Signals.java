package arcomat.pipeline.inside;

import arcomat.model.Value;
import arcomat.semantics.automaton.Input;
import arcomat.semantics.network.Network;

import java.util.List;

/** What the signals of a program carry in the step that is being told. */
interface Signals {
    /** A step begins. */
    void next();

    /** A part reads its inputs. */
    void read(Network.Instance part, Input input);

    void send(int signal, List<Value> messages);

    /** The messages of the step, in their order. */
    List<Value> shown(int signal);

    static Signals of(Network network) {
        return switch (network.component().profile()) {
            case TIME_SYNCHRONOUS -> new SliceSignals(network);
            case EVENT_DRIVEN -> new EventSignals(network);
        };
    }
}
