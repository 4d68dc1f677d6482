package arcomat.sim.memory;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;

/**
 * What is left of the brick's memory for a program's objects. Counts what is made; when that would
 * no longer fit, looks what is still in use, as the brick's collector does.
 */
public final class Heap {
    private final long size;
    private final Supplier<Map<Thread, CallStack>> threads;
    private final List<Class<?>> initialized = new ArrayList<>();
    private long used;

    /**
     * @param size in bytes
     * @param threads those of the program that run
     */
    public Heap(long size, Supplier<Map<Thread, CallStack>> threads) {
        this.size = size;
        this.threads = threads;
    }

    /** A class begins to have variables. */
    public void initialized(Class<?> type) {
        initialized.add(type);
    }

    /** An object of the program's own classes is being made; nobody refers to it yet. */
    public void make(Class<?> type) {
        reserve(ClassLayout.isOfJava(type) ? ObjectSize.ofFields(0) : ClassLayout.of(type).bytes());
    }

    public void makeArray(int length, Class<?> component) {
        if (length >= 0) {
            reserve(ObjectSize.ofArray(length, component));
        }
    }

    /** Java has made an object for the program, or has shown it one that was there. */
    public void given(Object object) {
        if (object != null && ClassLayout.isOfJava(object.getClass())) {
            used += ofArrays(object);
            if (used > size) {
                used = live(object);
                require(0);
            }
        }
    }

    /** An array of arrays is made in one go. */
    private static long ofArrays(Object object) {
        long bytes = ObjectSize.ofJava(object);
        if (object instanceof Object[][] arrays) {
            for (Object[] array : arrays) {
                bytes += array == null ? 0 : ofArrays(array);
            }
        } else if (object instanceof Object[] array
                && array.getClass().getComponentType().isArray()) {
            for (Object each : array) {
                bytes += each == null ? 0 : ObjectSize.ofJava(each);
            }
        }
        return bytes;
    }

    /** A collection of Java's, or a text, has become larger. */
    public void grown(int bytes) {
        reserve(bytes);
    }

    private void reserve(long bytes) {
        used += bytes;
        if (used > size) {
            used = live(null);
            require(bytes);
            used += bytes;
        }
    }

    private void require(long bytes) {
        if (used + bytes > size) {
            throw new OutOfMemoryError(
                    "%d of the brick's %d bytes for objects are in use%s"
                            .formatted(
                                    used,
                                    size,
                                    bytes == 0 ? "" : ", %d more are asked for".formatted(bytes)));
        }
    }

    private long live(@Nullable Object more) {
        LiveObjects objects = new LiveObjects();
        threads.get()
                .forEach(
                        (thread, stack) -> {
                            objects.addAll(thread);
                            objects.add(stack);
                        });
        initialized.forEach(objects::addStatics);
        objects.addAll(more);
        return objects.bytes();
    }

    /** Bytes that the program holds now. */
    public long inUse() {
        return live(null);
    }
}
