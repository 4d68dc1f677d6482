package arcomat.lower.statements;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** What the names among statements stand for at some moment. */
final class Frame {
    private final Map<String, Object> messages;
    private final Map<String, Deferred> values = new HashMap<>();

    /** What was sent; empty where that is silence. */
    final Map<String, Optional<Deferred>> sent = new LinkedHashMap<>();

    /**
     * @param messages of the ports that are not silent
     */
    Frame(Map<String, Object> messages, Map<String, Object> variables) {
        this.messages = messages;
        variables.forEach((name, value) -> values.put(name, Deferred.of(value)));
    }

    Optional<Object> message(String port) {
        return Optional.ofNullable(messages.get(port));
    }

    Deferred value(String name) {
        return name.equals("p") || name.equals("q")
                ? new Deferred(
                        Set.of(name), () -> messages.containsKey(name), () -> messages.get(name))
                : values.get(name);
    }

    void assign(String name, Deferred value) {
        values.put(name, value);
    }
}
