package arcomat.rt;

/**
 * Values one after the other: numbers and codes as they are, strings and objects beside them. Grows
 * where it has to, and is used again and again, so that nothing is made in a slice.
 */
final class Values {
    private static final int FIRST = 4;

    private long[] numbers = new long[FIRST];

    /** As long as the numbers; none before the first object. */
    private Object[] objects;

    private int size;

    int size() {
        return size;
    }

    long number(int index) {
        return numbers[index];
    }

    /** Null for a number. */
    Object object(int index) {
        return objects == null ? null : objects[index];
    }

    void add(long number) {
        grow();
        size++;
        set(size - 1, number);
    }

    void add(Object object) {
        grow();
        size++;
        set(size - 1, object);
    }

    void add(Values from, int index) {
        Object object = from.object(index);
        if (object == null) {
            add(from.numbers[index]);
        } else {
            add(object);
        }
    }

    void set(int index, long number) {
        numbers[index] = number;
        if (objects != null) {
            objects[index] = null;
        }
    }

    void set(int index, Object object) {
        keepObjects();
        numbers[index] = 0;
        objects[index] = object;
    }

    private void keepObjects() {
        if (objects == null) {
            objects = new Object[numbers.length];
        }
    }

    private void grow() {
        if (size == numbers.length) {
            long[] more = new long[2 * size];
            System.arraycopy(numbers, 0, more, 0, size);
            numbers = more;
            if (objects != null) {
                Object[] others = new Object[2 * size];
                System.arraycopy(objects, 0, others, 0, size);
                objects = others;
            }
        }
    }

    /** Twice as long, with the same beginning. */
    static int[] longer(int[] array) {
        int[] longer = new int[2 * array.length];
        System.arraycopy(array, 0, longer, 0, array.length);
        return longer;
    }

    /** Copies some values to an earlier place. */
    void move(int from, int to, int count) {
        for (int i = 0; i < count; i++) {
            numbers[to + i] = numbers[from + i];
            if (objects != null) {
                objects[to + i] = objects[from + i];
            }
        }
    }

    /** Forgets all but the first. */
    void cut(int first) {
        size = first;
    }

    boolean same(int index, Values that, int other) {
        Object mine = object(index);
        return mine == null
                ? numbers[index] == that.numbers[other] && that.object(other) == null
                : sameObjects(mine, that.object(other));
    }

    private static boolean sameObjects(Object mine, Object other) {
        return mine.equals(other);
    }

    int hash(int index) {
        Object object = object(index);
        return object == null ? (int) (numbers[index] ^ numbers[index] >>> 32) : hash(object);
    }

    private static int hash(Object object) {
        return object.hashCode();
    }
}
