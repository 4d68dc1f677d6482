package arcomat.rt;

/**
 * What a requirement asks for. The generated class at the bottom says it with the methods of this
 * one, run by run: where it goes, and then what is different there.
 */
public abstract class Requirement {
    /** The state after an input that leaves everything open. */
    protected static final int CHAOS = -1;

    /** Computes where a transition may go wrong; between {@link #risk} and {@link #unlessWrong}. */
    protected final Careful careful = new Careful();

    final String title;
    final String[] states;
    final String[] ports;

    /** What the outputs show. */
    final Messages seen;

    /** The runs that a step has led to. */
    Runs runs;

    /** The runs that a step begins with. */
    Runs before;

    /** Which of them goes on; none at the very beginning. */
    int going = -1;

    final Ending ending = new Ending();
    int slice;
    private int tried;

    Requirement(String title, String[] states, int variables, String[] ports) {
        this.title = title;
        this.states = states;
        this.ports = ports;
        seen = new Messages(ports.length);
        runs = new Runs(variables, ports.length);
        before = new Runs(variables, ports.length);
    }

    /** Calls {@link #show} for each output that shows a message. */
    protected abstract void see();

    /** Calls {@link #go} for each transition that is enabled. */
    protected abstract void react(int state);

    /**
     * Calls {@link #complete(String, int, int)} for what is done where no transition is enabled.
     */
    protected abstract void complete(int state);

    /**
     * A message that is no string and no object, as models write it.
     *
     * @param port position of the output
     */
    protected String text(int port, long message) {
        return String.valueOf(message);
    }

    /** The name of a state. */
    final String name(int state) {
        return state == CHAOS
                ? "chaos"
                : state < states.length ? states[state] : String.valueOf(state);
    }

    /** An output shows a message. */
    protected final void show(int port, long message) {
        seen.send(port, message);
    }

    /** Whoever sets a port that always has a message to none is heard, too. */
    protected final void show(int port, Object message) {
        if (message != null) {
            seen.send(port, message);
        }
    }

    /** The value of a variable. */
    protected final long number(int variable) {
        return before.number(going, variable);
    }

    /** The value of a variable. */
    protected final Object object(int variable) {
        return before.object(going, variable);
    }

    /** A run may begin or go on like this: silent, and with the variables as they are. */
    protected final void go(String cause, int state) {
        if (going < 0) {
            runs.add(cause, Runs.TAKEN, state);
        } else {
            runs.add(cause, Runs.TAKEN, state, before, going);
        }
    }

    /** Likewise, where no transition is enabled. */
    protected final void complete(String completion, int from, int state) {
        runs.add(completion, from, state, before, going);
    }

    /** The last run has another value in a variable. */
    protected final void set(int variable, long value) {
        runs.set(variable, value);
    }

    /** The last run has another value in a variable. */
    protected final void set(int variable, Object value) {
        runs.set(variable, value);
    }

    /** The last run sends a message. */
    protected final void send(int port, long message) {
        runs.promises().send(port, message);
    }

    /** The last run sends a message. */
    protected final void send(int port, Object message) {
        runs.promises().send(port, message);
    }

    /** The last run sends a message, whichever. */
    protected final void sendAny(int port) {
        runs.promises().open(port, Messages.ANY_MESSAGE);
    }

    /** The last run says nothing about a port. */
    protected final void leaveOpen(int port) {
        runs.promises().open(port, Messages.ANYTHING);
    }

    /** What comes now may go wrong. */
    protected final void risk() {
        careful.forget();
        tried = runs.size();
    }

    /** If it has gone wrong, it is no way to go on. */
    protected final void unlessWrong() {
        if (careful.isWrong()) {
            runs.cut(tried);
            ending.goesWrong(careful, slice);
        }
    }

    /** A truth value as a number. */
    protected static long code(boolean value) {
        return value ? 1 : 0;
    }

    /** A number with a fraction as one without. */
    protected static long code(double value) {
        return Double.doubleToLongBits(value);
    }

    /** As models write it. */
    protected static String quoted(char character) {
        return Accusation.quoted(String.valueOf(character), '\'');
    }
}
