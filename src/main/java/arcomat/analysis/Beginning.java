package arcomat.analysis;

import arcomat.semantics.Behaviour;
import arcomat.semantics.Fault;
import arcomat.semantics.Network;

import java.util.List;
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
        List<Behaviour> all =
                promise.isComposition()
                        ? Behaviour.ofParts(Network.of(promise.component(), promise.arguments()))
                        : List.of(promise.behaviour());
        all.forEach(Behaviour::starts);
    }
}
