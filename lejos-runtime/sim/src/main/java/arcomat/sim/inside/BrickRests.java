package arcomat.sim.inside;

import arcomat.sim.device.Hardware;
import arcomat.sim.time.SavedVariables;
import arcomat.sim.time.Strand;

import org.jspecify.annotations.Nullable;

/**
 * What calls that wait for the next slice do to leave their thread and to come back. Their methods
 * are made to ask here by {@code arcomat.sim.load.ReentrantMethod}.
 */
public final class BrickRests {
    private static final Hardware BRICK = Hardware.of(BrickRests.class);

    private BrickRests() {}

    /** As Thread.sleep; it may return at once, because the thread rests. */
    public static void sleep(long milliseconds) throws InterruptedException {
        BRICK.rest(milliseconds);
    }

    /** Whether the caller has to save its variables and return. */
    public static boolean rests() {
        return strand().rests();
    }

    /** Whether the caller has to take its variables, and call again what it was left in. */
    public static boolean resumes() {
        return strand().resumes();
    }

    public static void save(int number) {
        saved().save(number);
    }

    public static void save(long number) {
        saved().save(number);
    }

    public static void save(@Nullable Object object) {
        saved().save(object);
    }

    public static int takeInt() {
        return (int) saved().takeNumber();
    }

    public static long takeLong() {
        return saved().takeNumber();
    }

    public static @Nullable Object takeObject() {
        return saved().takeObject();
    }

    private static SavedVariables saved() {
        return strand().saved();
    }

    private static Strand strand() {
        return BRICK.time().running();
    }
}
