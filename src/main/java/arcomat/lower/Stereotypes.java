package arcomat.lower;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.symbols.ComponentSymbol;
import arcomat.symbols.Layer;
import arcomat.tree.Name;
import arcomat.tree.Stereotype;

import java.util.Optional;

/** Stereotypes with a meaning. Values are known here: the checks refuse others. */
final class Stereotypes {
    static final int DEFAULT_CAPACITY = 16;

    private Stereotypes() {}

    static Automaton.Completion completion(Optional<String> value) {
        return value.map(v -> Automaton.Completion.valueOf(v.toUpperCase(java.util.Locale.ROOT)))
                .orElse(Automaton.Completion.CHAOS);
    }

    static Automaton.Omitted omitted(Optional<String> value) {
        return value.filter("free"::equals).isPresent()
                ? Automaton.Omitted.FREE
                : Automaton.Omitted.SILENT;
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
        return Stereotype.find(component.stereotypes(), "capacity")
                .flatMap(Stereotype::value)
                .map(Name::text)
                .filter(text -> text.matches("[1-9][0-9]{0,5}"))
                .map(Integer::parseInt)
                .orElse(DEFAULT_CAPACITY);
    }
}
