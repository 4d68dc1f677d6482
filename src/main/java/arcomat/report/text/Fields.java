package arcomat.report.text;

import java.util.LinkedHashMap;
import java.util.Optional;

/** An object for {@link Json} whose form others lay down: a record would only repeat it. */
public final class Fields extends LinkedHashMap<String, Object> {
    private static final long serialVersionUID = 1L;

    public static Fields of(String name, Object value) {
        return new Fields().with(name, value);
    }

    public Fields with(String name, Object value) {
        put(name, value);
        return this;
    }

    /** No field for what is empty. */
    public Fields with(String name, Optional<?> value) {
        value.ifPresent(present -> put(name, present));
        return this;
    }
}
