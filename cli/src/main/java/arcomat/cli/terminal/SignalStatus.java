package arcomat.cli.terminal;

import java.util.function.IntSupplier;

/**
 * What a command ends with that goes on until somebody interrupts it: Ctrl-C is how it is meant to
 * end, and no failure.
 */
public final class SignalStatus {
    private final Thread hook;

    private SignalStatus(Thread hook) {
        this.hook = hook;
    }

    /**
     * Holds until it is closed.
     *
     * @param status asked when the process is told to end
     */
    public static SignalStatus of(IntSupplier status, Console console) {
        Runnable end =
                () -> {
                    console.out().flush();
                    console.halt().accept(status.getAsInt());
                };
        SignalStatus held = new SignalStatus(new Thread(end, "arcomat-signal"));
        Runtime.getRuntime().addShutdownHook(held.hook);
        return held;
    }

    /** The command has ended by itself. */
    public void close() {
        try {
            Runtime.getRuntime().removeShutdownHook(hook);
        } catch (IllegalStateException ending) {
            // The hook is running: it has the last word.
        }
    }
}
