package arcomat.simulate.test;

import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.value.InputAbstraction.Compared;
import arcomat.semantics.value.InputAbstraction.PortAbstraction;
import arcomat.semantics.value.InputAbstraction.Unseen;
import arcomat.semantics.value.MessageClasses;
import arcomat.semantics.value.TooManyMessages;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/**
 * Divides a message that is left open, and that the test expects nothing about, into what those who
 * read it tell apart. Where all values of a large type matter, some are tried.
 */
final class Division {
    /** As many values of a large type as are tried. */
    private static final int SOME = 64;

    /**
     * What a message may be.
     *
     * @param complete whether every other message has the effect of one of these
     */
    record Options(List<Sent> samples, boolean complete) {}

    private final Wires wires;
    private final List<ComponentSemantics> behaviours;
    private final Set<Value> mentioned;

    /**
     * @param mentioned values that may matter: those that the test speaks of
     */
    Division(Wires wires, List<ComponentSemantics> behaviours, Collection<Value> mentioned) {
        this.wires = wires;
        this.behaviours = behaviours;
        this.mentioned = new LinkedHashSet<>(mentioned);
    }

    /** Whether an instance looks at one of its ports in this slice. */
    boolean isSeen(Possibility possibility, int instance, int port) {
        return !(look(possibility, instance, port) instanceof Unseen);
    }

    Options of(Possibility possibility, int signal) {
        PortAbstraction look = new Unseen();
        for (Wires.Reader reader : wires.readers(signal)) {
            look = look.and(look(possibility, reader.instance(), reader.port()));
        }
        boolean required = !possibility.visible[signal].allows(List.of());
        return values(wires.port(signal), required, look, mentioned);
    }

    /**
     * What an open message may be.
     *
     * @param required whether there is one
     * @param look of all who read it
     */
    static Options values(
            Port sender, boolean required, PortAbstraction look, Collection<Value> mentioned) {
        try {
            List<Value> samples = MessageClasses.of(sender, required, look).samples();
            return new Options(samples.stream().map(Sent::of).toList(), true);
        } catch (TooManyMessages tooMany) {
            return some(sender, required, mentioned);
        }
    }

    private PortAbstraction look(Possibility possibility, int instance, int port) {
        return behaviours.get(instance).abstraction(possibility.before(instance)).looks().get(port);
    }

    /** Those that the test speaks of, the simplest one, and some between them. */
    private static Options some(Port port, boolean required, Collection<Value> mentioned) {
        List<Value> values = new ArrayList<>();
        mentioned.stream().filter(v -> port.type().has(v)).limit(SOME).forEach(values::add);
        values.add(port.type().first());
        List<Value> samples =
                MessageClasses.of(port, required, new Compared(values, true)).samples();
        return new Options(samples.stream().map(Sent::of).toList(), false);
    }
}
