package arcomat.sim.device;

import java.util.Map;
import java.util.Set;

/**
 * How errors call themselves on the brick: by the numbers of their classes, for names are not in a
 * linked program. leJOS' own machine knows these errors, so they have the same numbers in every
 * program; the number of any other depends on what is linked with it.
 */
public final class ErrorNumbers {
    private static final Map<Class<?>, Integer> NUMBERS =
            Map.ofEntries(
                    Map.entry(Throwable.class, 1),
                    Map.entry(Error.class, 2),
                    Map.entry(OutOfMemoryError.class, 3),
                    Map.entry(NoSuchMethodError.class, 14),
                    Map.entry(StackOverflowError.class, 15),
                    Map.entry(NullPointerException.class, 16),
                    Map.entry(ClassCastException.class, 26),
                    Map.entry(ArithmeticException.class, 27),
                    Map.entry(ArrayIndexOutOfBoundsException.class, 28),
                    Map.entry(IllegalArgumentException.class, 29),
                    Map.entry(InterruptedException.class, 30),
                    Map.entry(IllegalStateException.class, 31),
                    Map.entry(IllegalMonitorStateException.class, 32),
                    Map.entry(ThreadDeath.class, 33),
                    Map.entry(ArrayStoreException.class, 34),
                    Map.entry(NegativeArraySizeException.class, 35));

    /** Those that libraries throw, with messages, and programs. */
    private static final Set<Class<?>> OF_LIBRARIES =
            Set.of(
                    Throwable.class,
                    Error.class,
                    IllegalArgumentException.class,
                    IllegalStateException.class);

    private ErrorNumbers() {}

    /** The number of an error's class, or {@code ?} where only the linker knows it. */
    public static String of(Class<?> type) {
        Integer number = NUMBERS.get(type);
        return number == null ? "?" : number.toString();
    }

    /** Whether it is the machine that throws such errors, and gives them no message. */
    static boolean isOfMachine(Class<?> type) {
        return NUMBERS.containsKey(type) && !OF_LIBRARIES.contains(type);
    }
}
