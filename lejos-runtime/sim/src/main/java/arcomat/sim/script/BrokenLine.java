package arcomat.sim.script;

/** Gives up reading a line; the parser goes on with the next one. */
final class BrokenLine extends Exception {
    private final transient ScriptError error;

    BrokenLine(ScriptError error) {
        super(error.message());
        this.error = error;
    }

    ScriptError error() {
        return error;
    }
}
