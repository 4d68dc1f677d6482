package arcomat.check.stereotypes;

import arcomat.check.law.Carrier;
import arcomat.check.law.Suppressions;

import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * The stereotypes that mean something.
 *
 * @param carriers the elements on which it has its meaning
 * @param values the allowed values; empty if it takes none or has a form of its own
 */
record KnownStereotype(String name, Form form, Set<Carrier> carriers, List<String> values) {

    /** What may stand behind the equals sign. */
    enum Form {
        /** Nothing. */
        FLAG,
        /** One of the listed values. */
        CHOICE,
        /** A whole number from 1. */
        COUNT,
        /** Words. */
        REASON,
        /** The name of a component, a colon, and words. */
        NAME_AND_REASON,
        /** Nothing, or a message of the port; a law of its own looks at it. */
        MESSAGE,
        /** A code and a reason; a law of its own looks at it. */
        TEXT
    }

    private static final Set<Carrier> BEHAVIOUR = Set.of(Carrier.AUTOMATON);
    private static final Set<Carrier> COMPONENT = Set.of(Carrier.COMPONENT);
    private static final Set<Carrier> PROMISING = Set.of(Carrier.COMPONENT, Carrier.AUTOMATON);
    private static final Set<Carrier> PORT = Set.of(Carrier.PORT);

    static final List<KnownStereotype> ALL =
            List.of(
                    choice("completion", BEHAVIOUR, "chaos", "output", "ignore", "error"),
                    choice("omitted", BEHAVIOUR, "silent", "free"),
                    choice("violated", BEHAVIOUR, "stop", "continue"),
                    choice("layer", COMPONENT, "sensors", "logic", "actuators"),
                    choice("delay", PORT, "0", "1"),
                    new KnownStereotype("capacity", Form.COUNT, COMPONENT, List.of()),
                    new KnownStereotype("cycle", Form.COUNT, COMPONENT, List.of()),
                    flag("platform", COMPONENT),
                    flag("deploy", COMPONENT),
                    flag("map", COMPONENT),
                    flag("total", PORT),
                    new KnownStereotype("state", Form.MESSAGE, PORT, List.of()),
                    new KnownStereotype("breaks", Form.REASON, PROMISING, List.of()),
                    new KnownStereotype("replaces", Form.NAME_AND_REASON, PROMISING, List.of()),
                    new KnownStereotype(
                            Suppressions.STEREOTYPE,
                            Form.TEXT,
                            Set.of(Carrier.values()),
                            List.of()));

    private static KnownStereotype choice(String name, Set<Carrier> carriers, String... values) {
        return new KnownStereotype(name, Form.CHOICE, carriers, List.of(values));
    }

    private static KnownStereotype flag(String name, Set<Carrier> carriers) {
        return new KnownStereotype(name, Form.FLAG, carriers, List.of());
    }

    static Optional<KnownStereotype> find(String name) {
        return ALL.stream().filter(known -> known.name().equals(name)).findFirst();
    }

    static List<String> names() {
        return ALL.stream().map(KnownStereotype::name).toList();
    }
}
