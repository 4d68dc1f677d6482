package arcomat.sim.time;

/** Unwinds a thread of a program that is over. Never seen by the user of the simulation. */
public final class ProgramEnded extends Error {
    /** Without a stack trace: it says nothing that anybody reads. */
    public ProgramEnded() {
        super("the program has ended", null, false, false);
    }
}
