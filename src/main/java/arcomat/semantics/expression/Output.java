package arcomat.semantics.expression;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;

/**
 * A set of output letters as a cube: what is allowed on one port does not depend on the others.
 *
 * @param ports one per output port of the component, in the order of declaration
 */
public record Output(List<Sent> ports) {
    public Output {
        ports = List.copyOf(ports);
    }

    /** Every letter over so many ports. */
    public static Output anything(int ports) {
        return new Output(Collections.nCopies(ports, new Sent.Anything()));
    }

    /** What both allow; empty if that is nothing. */
    public Optional<Output> meet(Output other) {
        List<Sent> both = new ArrayList<>(ports.size());
        for (int i = 0; i < ports.size(); i++) {
            Optional<Sent> sent = ports.get(i).meet(other.ports.get(i));
            if (sent.isEmpty()) {
                return Optional.empty();
            }
            both.add(sent.get());
        }
        return Optional.of(new Output(both));
    }
}
