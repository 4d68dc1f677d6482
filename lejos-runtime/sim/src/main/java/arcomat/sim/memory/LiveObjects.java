package arcomat.sim.memory;

import org.jspecify.annotations.Nullable;

import java.lang.reflect.Field;
import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Collection;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.Map;
import java.util.Set;

/**
 * The objects that a program can still reach, and the memory that they take: what a collector would
 * leave. Walks along references, as the PC's own collector would tell at other moments each time.
 */
final class LiveObjects {
    private final Set<Object> seen = Collections.newSetFromMap(new IdentityHashMap<>());
    private final ArrayDeque<Object> open = new ArrayDeque<>();
    private long bytes;

    long bytes() {
        return bytes;
    }

    void add(CallStack stack) {
        bytes += stack.bytes();
        for (int slot = 0; slot < stack.top(); slot++) {
            add(stack.held(slot));
        }
        walk();
    }

    void addStatics(Class<?> type) {
        for (Field field : ClassLayout.statics(type)) {
            add(read(field, null));
        }
        walk();
    }

    /** Adds an object with everything that it leads to. */
    void addAll(@Nullable Object object) {
        add(object);
        walk();
    }

    private void add(@Nullable Object object) {
        if (object != null && !isOutside(object.getClass()) && seen.add(object)) {
            open.add(object);
        }
    }

    /** The simulation, and what stands for code: on the brick that is no object in the heap. */
    private static boolean isOutside(Class<?> type) {
        return type.getName().startsWith("arcomat.sim.")
                || type == Class.class
                || ClassLoader.class.isAssignableFrom(type);
    }

    private void walk() {
        while (!open.isEmpty()) {
            Object object = open.pop();
            if (ClassLayout.isOfJava(object.getClass())) {
                bytes += ObjectSize.ofJava(object);
            } else {
                ClassLayout layout = ClassLayout.of(object.getClass());
                bytes += layout.bytes();
                for (Field field : layout.references()) {
                    add(read(field, object));
                }
            }
            addContent(object);
        }
    }

    /** What objects of Java's own classes hold, as far as they show it. */
    private void addContent(Object object) {
        if (object instanceof Object[] array) {
            Arrays.stream(array).forEach(this::add);
        } else if (object instanceof Collection<?> collection && isJavas(object, "iterator")) {
            for (Object each : collection) {
                add(each);
            }
        } else if (object instanceof Map<?, ?> map && isJavas(object, "entrySet")) {
            for (Map.Entry<?, ?> entry : map.entrySet()) {
                add(entry.getKey());
                add(entry.getValue());
            }
        } else if (object instanceof Enum<?> constant) {
            add(constant.name());
        }
    }

    /** A program's own method must not run now. */
    private static boolean isJavas(Object object, String method) {
        try {
            return ClassLayout.isOfJava(object.getClass().getMethod(method).getDeclaringClass());
        } catch (NoSuchMethodException e) {
            return false;
        }
    }

    private static @Nullable Object read(Field field, @Nullable Object object) {
        try {
            return field.get(object);
        } catch (IllegalAccessException e) {
            throw new AssertionError("accessible since it was found", e);
        }
    }
}
