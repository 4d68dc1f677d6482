package arcomat.sim.device;

import org.jspecify.annotations.Nullable;

import java.util.Collections;
import java.util.Set;
import java.util.WeakHashMap;

/** What the errors of a program say of themselves on the brick. */
public final class Errors {
    /**
     * Errors of the machine's classes that the program has made itself: they keep their message.
     */
    private final Set<Throwable> made = Collections.newSetFromMap(new WeakHashMap<>());

    Errors() {}

    /** The program has made an error. */
    public void make(Throwable error) {
        if (ErrorNumbers.isOfMachine(error.getClass())) {
            made.add(error);
        }
    }

    /** Its message; null if it has none, as all that the machine throws. */
    public @Nullable String message(Throwable error) {
        boolean silent = ErrorNumbers.isOfMachine(error.getClass()) && !made.contains(error);
        return silent ? null : error.getMessage();
    }

    /** A program's own error may fail to say what it is. */
    private @Nullable String shownMessage(Throwable error) {
        try {
            return message(error);
        } catch (RuntimeException | Error e) {
            return null;
        }
    }

    /** What the brick shows of an error that nothing has caught; ESCAPE would take it away. */
    void show(Throwable error, Screen screen) {
        screen.clear();
        int row = 0;
        for (Throwable each = error; each != null; each = each.getCause()) {
            String heading = each == error ? "Exception: " : "Caused by: ";
            screen.draw(heading + ErrorNumbers.of(each.getClass()), 0, row++);
            String message = shownMessage(each);
            if (message != null) {
                screen.draw(message, 0, row++);
            }
        }
    }
}
