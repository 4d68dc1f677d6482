package arcomat.sim.memory;

import java.lang.reflect.Array;
import java.util.Collection;
import java.util.List;
import java.util.Map;

/**
 * Bytes that an object takes on the brick, without what it refers to; as leJOS lays them out, where
 * that is known. Its own collections and builders are not there to be measured: they count as what
 * they have to hold at least.
 */
final class ObjectSize {
    private static final int HEADER = 4;
    private static final int REFERENCE = 4;
    private static final int CHARACTER = 2;

    /** Arrays of more elements have their length behind the header. */
    private static final int SHORT_ARRAY = 254;

    private static final int LONG_LENGTH = 4;
    private static final int ALIGNMENT = 4;

    /** Of an entry in a map, or in anything linked: three references and a number. */
    private static final int ENTRY = HEADER + 3 * REFERENCE + 4;

    /** What a collection has besides its content. */
    private static final int COLLECTION = HEADER + 3 * REFERENCE;

    /** Of an object of the brick's Java that is nothing of the above. */
    private static final int OTHER = 16;

    private ObjectSize() {}

    static int ofArray(long length, Class<?> component) {
        long bytes = HEADER + (length > SHORT_ARRAY ? LONG_LENGTH : 0) + length * of(component);
        return aligned(bytes);
    }

    /** Of an object with so many bytes of fields. */
    static int ofFields(int bytes) {
        return aligned(HEADER + bytes);
    }

    /** Of a value in a field or in an array. */
    static int of(Class<?> type) {
        if (!type.isPrimitive()) {
            return REFERENCE;
        }
        if (type == long.class || type == double.class) {
            return 8;
        }
        if (type == int.class || type == float.class) {
            return 4;
        }
        return type == char.class || type == short.class ? 2 : 1;
    }

    /** Of an object of Java's own classes. */
    static int ofJava(Object object) {
        if (object.getClass().isArray()) {
            return ofArray(Array.getLength(object), object.getClass().getComponentType());
        } else if (object instanceof String text) {
            return HEADER + REFERENCE + characters(text.length());
        } else if (object instanceof StringBuilder text) {
            return HEADER + 2 * REFERENCE + characters(text.capacity());
        } else if (object instanceof StringBuffer text) {
            return HEADER + 2 * REFERENCE + characters(text.capacity());
        } else if (object instanceof Long || object instanceof Double) {
            return HEADER + 8;
        } else if (object instanceof Number
                || object instanceof Character
                || object instanceof Boolean) {
            return HEADER + 4;
        } else if (object instanceof List<?> list) {
            return COLLECTION + ofArray(list.size(), Object.class);
        } else if (object instanceof Collection<?> collection) {
            return COLLECTION + collection.size() * (ENTRY + REFERENCE);
        } else if (object instanceof Map<?, ?> map) {
            return COLLECTION + map.size() * (ENTRY + REFERENCE);
        }
        return OTHER;
    }

    private static int characters(int count) {
        return ofArray(count, char.class);
    }

    private static int aligned(long bytes) {
        long rounded = (bytes + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
        return (int) Math.min(rounded, Integer.MAX_VALUE);
    }
}
