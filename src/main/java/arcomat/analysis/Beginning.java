package arcomat.analysis;

import arcomat.semantics.Behaviour;
import arcomat.semantics.Fault;
import arcomat.semantics.Network;

import java.util.Optional;

/** Whether a side can begin at all: a value that it starts with may be none of its type. */
final class Beginning {
    private Beginning() {}

    static Optional<String> obstacle(Promise promise) {
        try {
            begin(promise);
            return Optional.empty();
        } catch (Fault fault) {
            return Optional.of(
                    "the model goes wrong before it reads anything: " + fault.getMessage());
        }
    }

    private static void begin(Promise promise) {
        if (!promise.isComposition()) {
            promise.behaviour().starts();
            return;
        }
        for (Network.Instance part :
                Network.of(promise.component(), promise.arguments()).instances()) {
            Behaviour.of(part.component(), part.arguments()).starts();
        }
    }
}
