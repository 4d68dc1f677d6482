package arcomat.pipeline.compile;

import org.jspecify.annotations.Nullable;

import java.lang.reflect.Array;
import java.lang.reflect.Field;
import java.util.Objects;

/** A field of one object of compiled code. */
public final class Slot {
    private final Object owner;
    private final Field field;

    public Slot(Object owner, String name) {
        this.owner = owner;
        this.field = find(owner.getClass(), name);
        field.setAccessible(true);
    }

    /** Parts of event-driven networks are of classes of their own that extend the generated one. */
    private static Field find(Class<?> type, String name) {
        try {
            return type.getDeclaredField(name);
        } catch (NoSuchFieldException e) {
            if (type.getSuperclass() == null) {
                throw new IllegalStateException(e);
            }
            return find(type.getSuperclass(), name);
        }
    }

    /** The object to which fields lead, with dots between them: {@code section.cells[3]}. */
    public static Object follow(Object owner, String fields) {
        return Objects.requireNonNull(reach(owner, fields));
    }

    /** The same; null where it has not been made. */
    public static @Nullable Object reach(Object owner, String fields) {
        Object object = owner;
        for (String field : fields.split("\\.")) {
            object = object == null ? null : member(object, field);
        }
        return object;
    }

    /** A field, or an element of an array: {@code cells[3]}. */
    private static @Nullable Object member(Object owner, String field) {
        int bracket = field.indexOf('[');
        if (bracket < 0) {
            return new Slot(owner, field).get();
        }
        Object array = new Slot(owner, field.substring(0, bracket)).get();
        int index = Integer.parseInt(field.substring(bracket + 1, field.length() - 1));
        return array == null ? null : Array.get(array, index);
    }

    public Object get() {
        try {
            return field.get(owner);
        } catch (IllegalAccessException e) {
            throw new IllegalStateException(e);
        }
    }

    int getInt() {
        return ((Number) get()).intValue();
    }

    public void set(Object value) {
        try {
            field.set(owner, value);
        } catch (IllegalAccessException e) {
            throw new IllegalStateException(e);
        }
    }
}
