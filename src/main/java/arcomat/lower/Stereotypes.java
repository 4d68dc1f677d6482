package arcomat.lower;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.signatures.Layer;
import arcomat.tree.Name;
import arcomat.tree.Stereotype;

import java.util.Locale;
import java.util.Optional;

/** Stereotypes with a meaning. Values are known here: the checks refuse others. */
final class Stereotypes {
    static final int DEFAULT_CAPACITY = 16;

    /** The usual length of a slice, in milliseconds. */
    static final int DEFAULT_CYCLE = 100;

    private Stereotypes() {}

    static Automaton.Completion completion(Optional<String> value) {
        return value.map(v -> Automaton.Completion.valueOf(v.toUpperCase(Locale.ROOT)))
                .orElse(Automaton.Completion.CHAOS);
    }

    static Automaton.Omitted omitted(Optional<String> value) {
        return value.filter("free"::equals).isPresent()
                ? Automaton.Omitted.FREE
                : Automaton.Omitted.SILENT;
    }

    static Automaton.Violated violated(Optional<String> value) {
        return value.filter("continue"::equals).isPresent()
                ? Automaton.Violated.CONTINUE
                : Automaton.Violated.STOP;
    }

    static Component.Layer layer(Layer layer) {
        return switch (layer) {
            case SENSORS -> Component.Layer.SENSORS;
            case LOGIC -> Component.Layer.LOGIC;
            case ACTUATORS -> Component.Layer.ACTUATORS;
        };
    }

    /** How many events wait for an event-driven component: {@code <<capacity = "32">>}. */
    static int queueCapacity(ComponentSymbol component) {
        return count(component, "capacity", DEFAULT_CAPACITY);
    }

    /** The milliseconds of a slice on a robot: {@code <<cycle = "50">>}. */
    static int cycle(ComponentSymbol component) {
        return count(component, "cycle", DEFAULT_CYCLE);
    }

    private static int count(ComponentSymbol component, String stereotype, int usual) {
        return Stereotype.find(component.stereotypes(), stereotype)
                .flatMap(Stereotype::value)
                .map(Name::text)
                .filter(text -> text.matches("[1-9][0-9]{0,5}"))
                .map(Integer::parseInt)
                .orElse(usual);
    }
}
