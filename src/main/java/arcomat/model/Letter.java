package arcomat.model;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * What the ports carry in one slice or step. Ports without a message are left out. In the
 * time-synchronous profile every port carries at most one message.
 */
public record Letter(Map<String, List<Value>> messages) {
    /** No message on any port. */
    public static final Letter SILENCE = new Letter(Map.of());

    public Letter {
        Map<String, List<Value>> copy = new LinkedHashMap<>();
        messages.forEach(
                (port, values) -> {
                    if (!values.isEmpty()) {
                        copy.put(port, List.copyOf(values));
                    }
                });
        messages = Collections.unmodifiableMap(copy);
    }

    /** One message per named port. */
    public static Letter of(Map<String, Value> single) {
        Map<String, List<Value>> lists = new LinkedHashMap<>();
        single.forEach((port, value) -> lists.put(port, List.of(value)));
        return new Letter(lists);
    }

    /**
     * The messages on some ports.
     *
     * @param messages by position of the port, null where there is none
     */
    public static Letter of(List<Port> ports, Value[] messages) {
        Map<String, Value> named = new LinkedHashMap<>();
        for (int i = 0; i < messages.length; i++) {
            if (messages[i] != null) {
                named.put(ports.get(i).name(), messages[i]);
            }
        }
        return of(named);
    }

    /** The first message on a port. */
    public Optional<Value> message(String port) {
        List<Value> values = messages.get(port);
        return values == null ? Optional.empty() : Optional.of(values.get(0));
    }

    public List<Value> messages(String port) {
        return messages.getOrDefault(port, List.of());
    }

    public boolean isSilent() {
        return messages.isEmpty();
    }
}
