package arcomat.sim.inside;

import arcomat.sim.device.Hardware;
import arcomat.sim.memory.CallStack;

/** What leJOS' virtual machine does beside a program: counts its calls, its work, its objects. */
public final class BrickMachine {
    private static final Hardware BRICK = Hardware.of(BrickMachine.class);

    private BrickMachine() {}

    /**
     * A method begins.
     *
     * @param variables of it that may hold objects
     * @param frame bytes that the call takes
     * @param work microseconds of its first block
     * @return the depth of the call
     */
    public static int enter(int variables, int frame, int work) {
        BRICK.processor().count(work);
        return calls().enter(variables, frame);
    }

    public static void leave() {
        calls().leave();
    }

    /** An error is caught by the method that has entered at this depth. */
    public static void caught(int depth, int variables) {
        calls().caught(depth, variables);
    }

    public static void hold(Object object, int variable) {
        calls().hold(object, variable);
    }

    public static void work(int microseconds) {
        BRICK.processor().work(microseconds);
    }

    /** As {@link #work}, where others must not have their turn. */
    public static void count(int microseconds) {
        BRICK.processor().count(microseconds);
    }

    public static void initialized(Class<?> type) {
        BRICK.heap().initialized(type);
    }

    public static void make(Class<?> type) {
        BRICK.heap().make(type);
    }

    /** An array is being made; its length is passed through. */
    public static int makeArray(int length, Class<?> component) {
        BRICK.heap().makeArray(length, component);
        return length;
    }

    public static void given(Object object) {
        BRICK.heap().given(object);
    }

    public static void grown(int bytes) {
        BRICK.heap().grown(bytes);
    }

    /** The clock of slices is asked to wait. */
    public static void await(Object clock) {
        BRICK.slices().await(clock);
    }

    public static void awaited() {
        BRICK.slices().awaited();
    }

    private static CallStack calls() {
        return BRICK.time().running().calls();
    }
}
