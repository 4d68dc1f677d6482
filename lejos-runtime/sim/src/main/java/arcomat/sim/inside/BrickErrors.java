package arcomat.sim.inside;

import arcomat.sim.device.ErrorNumbers;
import arcomat.sim.device.Hardware;

import org.jspecify.annotations.Nullable;

import java.io.PrintStream;

/**
 * Stands in for what java.lang.Throwable says of itself. On the brick a class has a number and no
 * name, and what the virtual machine throws has no message.
 */
public final class BrickErrors {
    private static final Hardware BRICK = Hardware.of(BrickErrors.class);

    private BrickErrors() {}

    /** The program has made an error. */
    public static void made(Throwable error) {
        BRICK.errors().make(error);
    }

    public static @Nullable String getMessage(Throwable error) {
        return BRICK.errors().message(error);
    }

    public static @Nullable String getLocalizedMessage(Throwable error) {
        return getMessage(error);
    }

    public static String toString(Throwable error) {
        return saysItself(error) ? error.toString() : described(error);
    }

    private static String described(Throwable error) {
        String message = getMessage(error);
        String name = "class " + ErrorNumbers.of(error.getClass());
        return message == null ? name : name + ": " + message;
    }

    public static void printStackTrace(Throwable error) {
        printStackTrace(error, BrickSystem.err);
    }

    public static void printStackTrace(Throwable error, PrintStream out) {
        for (Throwable each = error; each != null; each = each.getCause()) {
            out.println((each == error ? "" : "Caused by: ") + toString(each));
        }
    }

    /** What becomes text as part of a longer one. */
    public static Object shown(Object object) {
        return object instanceof Throwable error ? toString(error) : object;
    }

    /** Whether the program's own class says how its errors look. */
    private static boolean saysItself(Throwable error) {
        try {
            Class<?> type = error.getClass().getMethod("toString").getDeclaringClass();
            return type != Throwable.class;
        } catch (NoSuchMethodException e) {
            throw new AssertionError("every object has it", e);
        }
    }
}
