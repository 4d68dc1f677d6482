package arcomat.pipeline;

import java.lang.reflect.Field;

/** A field of one object of compiled code. */
final class Slot {
    private final Object owner;
    private final Field field;

    Slot(Object owner, String name) {
        this.owner = owner;
        try {
            field = owner.getClass().getDeclaredField(name);
            field.setAccessible(true);
        } catch (NoSuchFieldException e) {
            throw new IllegalStateException(e);
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
