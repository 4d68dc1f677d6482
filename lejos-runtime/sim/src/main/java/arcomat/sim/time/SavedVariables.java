package arcomat.sim.time;

import org.jspecify.annotations.Nullable;

import java.util.Arrays;

/**
 * What the calls of a strand had in their variables when it left them, until it comes back. The
 * innermost call is left first and entered last, so what was saved last is taken first.
 */
public final class SavedVariables {
    private static final int INITIAL = 16;

    private long[] numbers = new long[INITIAL];
    private @Nullable Object[] objects = new @Nullable Object[INITIAL];
    private int numberCount;
    private int objectCount;

    public void save(long number) {
        if (numberCount == numbers.length) {
            numbers = Arrays.copyOf(numbers, 2 * numberCount);
        }
        numbers[numberCount++] = number;
    }

    public void save(@Nullable Object object) {
        if (objectCount == objects.length) {
            objects = Arrays.copyOf(objects, 2 * objectCount);
        }
        objects[objectCount++] = object;
    }

    public long takeNumber() {
        return numbers[--numberCount];
    }

    public @Nullable Object takeObject() {
        Object object = objects[--objectCount];
        objects[objectCount] = null;
        return object;
    }
}
