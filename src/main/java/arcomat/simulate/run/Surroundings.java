package arcomat.simulate.run;

import arcomat.model.Letter;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.rt.ModelError;
import arcomat.semantics.network.Network;
import arcomat.simulate.run.Actor.Impasse;

import java.util.HashMap;
import java.util.Map;

/**
 * The border of a network: only known ports, only messages of their types. Every engine,
 * interpreted or compiled, asks it the same questions.
 */
public final class Surroundings {
    private final Network network;
    private final Map<String, Network.External> inputs = new HashMap<>();

    public Surroundings(Network network) {
        this.network = network;
        network.inputs().forEach(external -> inputs.put(external.name(), external));
    }

    /**
     * @throws IllegalArgumentException for a port that does not exist
     * @throws ModelError for a number outside the range of its port
     */
    public void requireKnownPorts(Letter letter) {
        letter.messages()
                .forEach(
                        (name, values) -> {
                            Network.External external = inputs.get(name);
                            if (external == null) {
                                throw new IllegalArgumentException(
                                        network.component().name() + " has no input " + name);
                            }
                            values.forEach(value -> requireRange(external, value));
                        });
    }

    /**
     * What the surroundings owe to a time-synchronous network in every slice.
     *
     * @throws IllegalArgumentException for a port that does not exist or has several messages
     * @throws ModelError for a total port without a message, or a number outside the range of its
     *     port
     */
    public void requireSlice(Letter letter) {
        requireKnownPorts(letter);
        for (Network.External external : network.inputs()) {
            int messages = letter.messages(external.name()).size();
            if (messages > 1) {
                throw new IllegalArgumentException(
                        "more than one message in a slice on " + external.name());
            }
            if (messages == 0 && external.port().total()) {
                throw new Impasse("no message on " + external.name() + ", which is <<total>>");
            }
        }
    }

    private static void requireRange(Network.External external, Value value) {
        if (external.port().type() instanceof Type.IntegerType type
                && value instanceof Value.IntegerValue number
                && (number.value() < type.low() || number.value() > type.high())) {
            throw new Impasse(
                    external.name()
                            + " = "
                            + value
                            + " from outside is not of type "
                            + type.name());
        }
    }
}
