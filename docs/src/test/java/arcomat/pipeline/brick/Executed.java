package arcomat.pipeline.brick;

/** Counts what a program does; one copy of this class lies in the program itself. */
public final class Executed {
    public static long bytecodes;
    public static long calls;

    private Executed() {}

    /** One instruction of the program. */
    public static void bytecode() {
        bytecodes++;
    }

    /** One call, of a method of the program or of leJOS. */
    public static void call() {
        calls++;
    }
}
