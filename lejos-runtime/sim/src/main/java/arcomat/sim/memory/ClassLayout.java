package arcomat.sim.memory;

import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
import java.util.ArrayList;
import java.util.List;

/**
 * What objects of a class of a program consist of.
 *
 * @param bytes that each takes
 * @param references the fields that refer to others
 */
record ClassLayout(int bytes, List<Field> references) {
    /** What leJOS keeps in a thread, in an error, and in a constant of an enum. */
    private static final int THREAD = 40;

    private static final int THROWABLE = 12;
    private static final int ENUM = 8;

    private static final ClassValue<ClassLayout> KNOWN =
            new ClassValue<>() {
                @Override
                protected ClassLayout computeValue(Class<?> type) {
                    return read(type);
                }
            };

    static ClassLayout of(Class<?> type) {
        return KNOWN.get(type);
    }

    private static ClassLayout read(Class<?> type) {
        int bytes = 0;
        List<Field> references = new ArrayList<>();
        Class<?> each = type;
        while (!isOfJava(each)) {
            for (Field field : each.getDeclaredFields()) {
                if (!Modifier.isStatic(field.getModifiers())) {
                    bytes += ObjectSize.of(field.getType());
                    addReference(field, references);
                }
            }
            each = each.getSuperclass();
        }
        return new ClassLayout(ObjectSize.ofFields(bytes + inherited(each)), references);
    }

    private static void addReference(Field field, List<Field> references) {
        if (!field.getType().isPrimitive()) {
            field.setAccessible(true);
            references.add(field);
        }
    }

    /** The variables of a class that may hold objects. */
    static List<Field> statics(Class<?> type) {
        List<Field> references = new ArrayList<>();
        for (Field field : type.getDeclaredFields()) {
            if (Modifier.isStatic(field.getModifiers())) {
                addReference(field, references);
            }
        }
        return references;
    }

    /** Whether its fields are those of the PC's Java, which says nothing of the brick's. */
    static boolean isOfJava(Class<?> type) {
        return type.getName().startsWith("java.") || type.isArray();
    }

    private static int inherited(Class<?> type) {
        if (Thread.class.isAssignableFrom(type)) {
            return THREAD;
        }
        if (Throwable.class.isAssignableFrom(type)) {
            return THROWABLE;
        }
        return Enum.class.isAssignableFrom(type) ? ENUM : 0;
    }
}
