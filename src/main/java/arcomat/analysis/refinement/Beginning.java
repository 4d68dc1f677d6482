package arcomat.analysis.refinement;

import arcomat.semantics.automaton.Behaviour;
import arcomat.semantics.expression.Fault;
import arcomat.semantics.network.Network;

import java.util.List;
import java.util.Optional;

/** Whether a side can begin at all: a value that it starts with may be none of its type. */
final class Beginning {
    private Beginning() {}

    /**
     * @param goOn asked on the way; it may throw what ends the work
     */
    static Optional<String> obstacle(Promise promise, Runnable goOn) {
        try {
            begin(promise, goOn);
            return Optional.empty();
        } catch (Fault fault) {
            return Optional.of(
                    "the model goes wrong before it reads anything: " + fault.getMessage());
        }
    }

    private static void begin(Promise promise, Runnable goOn) {
        List<Behaviour> all =
                promise.isComposition()
                        ? Behaviour.ofParts(
                                Network.of(promise.component(), promise.arguments()), goOn)
                        : List.of(promise.behaviour());
        all.forEach(Behaviour::starts);
    }
}
