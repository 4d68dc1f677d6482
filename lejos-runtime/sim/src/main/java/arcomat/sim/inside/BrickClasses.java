package arcomat.sim.inside;

import arcomat.sim.device.Hardware;

import org.jspecify.annotations.Nullable;

import java.util.HashMap;
import java.util.Map;

/**
 * Stands in for what Java knows and says of classes whose initializers have failed, where classes
 * begin again.
 */
public final class BrickClasses {
    /** What went wrong, by class; none as long as nothing has. */
    private static @Nullable Map<String, String> failures;

    private BrickClasses() {}

    /** A class is about to begin; it may have failed before. */
    public static void check(String name) {
        String reason = failures == null ? null : failures.get(name);
        if (reason != null) {
            NoClassDefFoundError error =
                    new NoClassDefFoundError("Could not initialize class " + name);
            error.initCause(new ExceptionInInitializerError(reason));
            throw error;
        }
    }

    /** What whoever needed a class is told of an error in its initializer. */
    public static Error failed(Throwable error, String name) {
        if (failures == null) {
            failures = new HashMap<>();
        }
        failures.put(name, reason(error));
        return error instanceof Error it ? it : new ExceptionInInitializerError(error);
    }

    private static String reason(Throwable error) {
        String message = error.getMessage();
        return "Exception %s%s [in thread \"%s\"]"
                .formatted(
                        error.getClass().getName(),
                        message == null ? "" : ": " + message,
                        thread());
    }

    /** Classes ask before anything of this one has begun, so its brick is looked up. */
    private static String thread() {
        return Hardware.of(BrickClasses.class).time().running().name();
    }
}
