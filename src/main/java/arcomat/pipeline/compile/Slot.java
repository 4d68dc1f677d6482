package arcomat.pipeline.compile;

import java.lang.reflect.Field;

/** A field of one object of compiled code. */
final class Slot {
    private final Object owner;
    private final Field field;

    Slot(Object owner, String name) {
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

    Object get() {
        try {
            return field.get(owner);
        } catch (IllegalAccessException e) {
            throw new IllegalStateException(e);
        }
    }

    int getInt() {
        return ((Number) get()).intValue();
    }

    void set(Object value) {
        try {
            field.set(owner, value);
        } catch (IllegalAccessException e) {
            throw new IllegalStateException(e);
        }
    }
}
