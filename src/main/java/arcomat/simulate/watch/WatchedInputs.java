package arcomat.simulate.watch;

import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.automaton.Input;

import org.jspecify.annotations.Nullable;

import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * What a requirement reads of what comes in: all of a slice, or an event with what its latched
 * ports hold at that time.
 */
final class WatchedInputs {
    /** What happens in a step. */
    enum Kind {
        /** Only latched ports have changed. */
        NOTHING,
        /** A slice, or an event on a port of the requirement. */
        LETTER,
        /** An event on a port that the requirement does not have: no transition handles it. */
        FOREIGN,
        /** More than one event: who takes which first, is the component's affair. */
        SEVERAL
    }

    private final Component component;
    private final Component running;
    private final Value[] held;

    WatchedInputs(Component component, Component running) {
        this.component = component;
        this.running = running;
        this.held = new Value[component.inputs().size()];
    }

    /** Empty where nothing is read. */
    record Reading(Kind kind, Optional<Input> input) {}

    Reading read(Letter letter) {
        if (component.profile() == Component.Profile.TIME_SYNCHRONOUS) {
            return new Reading(Kind.LETTER, Optional.of(Input.of(component, letter)));
        }
        int events = 0;
        for (Map.Entry<String, List<Value>> port : letter.messages().entrySet()) {
            boolean latched = running.port(port.getKey()).map(Port::latched).orElse(false);
            events += latched ? 0 : port.getValue().size();
        }
        Value[] messages = messages(letter);
        if (events != 1) {
            return new Reading(events == 0 ? Kind.NOTHING : Kind.SEVERAL, Optional.empty());
        }
        return messages == null
                ? new Reading(Kind.FOREIGN, Optional.empty())
                : new Reading(Kind.LETTER, Optional.of(Input.of(messages)));
    }

    /** Latches what is to be; null where no port of the requirement has an event. */
    private Value @Nullable [] messages(Letter letter) {
        List<Port> ports = component.inputs();
        int event = -1;
        for (int i = 0; i < held.length; i++) {
            List<Value> values = letter.messages(ports.get(i).name());
            if (!values.isEmpty() && ports.get(i).latched()) {
                held[i] = values.get(values.size() - 1);
            } else if (!values.isEmpty()) {
                event = i;
            }
        }
        if (event < 0) {
            return null;
        }
        Value[] messages = held.clone();
        messages[event] = letter.messages(ports.get(event).name()).get(0);
        return messages;
    }
}
