package arcomat.sim.inside;

import arcomat.sim.device.Hardware;
import arcomat.sim.device.Processor;

import lejos.nxt.LCDOutputStream;

import java.io.PrintStream;

/** Stands in for java.lang.System and java.lang.Runtime. */
public final class BrickSystem {
    private static final Hardware BRICK = Hardware.of(BrickSystem.class);
    private static final long NANOSECONDS_PER_MICROSECOND = 1000;

    /** As on the brick, what is printed appears on the screen. */
    public static PrintStream out = new PrintStream(new LCDOutputStream());

    public static PrintStream err = out;

    private BrickSystem() {}

    public static void setOut(PrintStream newOut) {
        out = newOut;
    }

    public static void setErr(PrintStream newErr) {
        err = newErr;
    }

    /** Milliseconds since boot. */
    public static long currentTimeMillis() {
        return BRICK.called().milliseconds();
    }

    public static long nanoTime() {
        return BRICK.called().time().now() * NANOSECONDS_PER_MICROSECOND;
    }

    public static void exit(int status) {
        BRICK.lifetime().exit();
        BRICK.time().spend(0); // does not return
    }

    public static void exit(Runtime runtime, int status) {
        exit(status);
    }

    public static void halt(Runtime runtime, int status) {
        exit(status);
    }

    /** When objects are looked for that nobody needs is no concern of the program's. */
    public static void gc() {
        BRICK.called();
    }

    public static void gc(Runtime runtime) {
        gc();
    }

    /** A program jumps back in its code. */
    public static void loop() {
        BRICK.time().spend(Processor.ROUND);
    }
}
