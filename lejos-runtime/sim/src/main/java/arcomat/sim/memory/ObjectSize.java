package arcomat.sim.memory;

import static arcomat.sim.memory.ObjectLayout.HEADER;
import static arcomat.sim.memory.ObjectLayout.REFERENCE;

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
    /** Of an entry in a map, or in anything linked: three references and a number. */
    private static final int ENTRY = HEADER + 3 * REFERENCE + 4;

    /** What a collection has besides its content. */
    private static final int COLLECTION = HEADER + 3 * REFERENCE;

    /** Of an object of the brick's Java that is nothing of the above. */
    private static final int OTHER = 16;

    private ObjectSize() {}

    static int ofArray(long length, Class<?> component) {
        return limited(ObjectLayout.array(length, of(component)));
    }

    /** Of an object with so many bytes of fields. */
    static int ofFields(int bytes) {
        return limited(ObjectLayout.object(bytes));
    }

    /** Of a value in a field or in an array. */
    static int of(Class<?> type) {
        return ObjectLayout.value(type.descriptorString());
    }

    /** Of an object of Java's own classes. */
    static int ofJava(Object object) {
        if (object.getClass().isArray()) {
            return ofArray(Array.getLength(object), object.getClass().getComponentType());
        } else if (object instanceof String text) {
            return limited(ObjectLayout.text(text.length()));
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

    private static int limited(long bytes) {
        return (int) Math.min(bytes, Integer.MAX_VALUE);
    }
}
