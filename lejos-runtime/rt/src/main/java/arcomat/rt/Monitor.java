package arcomat.rt;

import java.util.ArrayList;
import java.util.HashSet;

/**
 * Watches the ports of a component for one requirement. A requirement may allow several runs; the
 * monitor follows all of those that agree with what was seen, and when none is left the requirement
 * is violated. A requirement that has come to promise nothing any more is satisfied for good.
 *
 * <p>What a requirement asks for is in the generated class below this one. Whoever uses it sets the
 * ports to what is visible in a slice, then calls {@link #slice}.
 */
public abstract class Monitor {
    /** The state after an input that leaves everything open. */
    protected static final int CHAOS = -1;

    /** No message. */
    protected static final Object SILENCE = new Promise("--");

    /** Some message, whichever. */
    protected static final Object ANY_MESSAGE = new Promise("?");

    /** A message or none. */
    protected static final Object ANYTHING = new Promise("anything");

    /** What is promised about a port, where it is no certain message. */
    private static final class Promise {
        private final String text;

        Promise(String text) {
            this.text = text;
        }

        @Override
        public String toString() {
            return text;
        }
    }

    /** A run: where it is, what is to be seen on each output, and what in the model says so. */
    private static final class Run {
        final String cause;
        final int state;
        final Object[] variables;
        final Object[] promises;

        Run(String cause, int state, Object[] variables, Object[] promises) {
            this.cause = cause;
            this.state = state;
            this.variables = variables;
            this.promises = promises;
        }

        /** Promises that have been kept make no difference. */
        @Override
        public boolean equals(Object other) {
            if (!(other instanceof Run)) {
                return false;
            }
            Run that = (Run) other;
            boolean same = state == that.state;
            for (int i = 0; same && i < variables.length; i++) {
                same = variables[i].equals(that.variables[i]);
            }
            return same;
        }

        @Override
        public int hashCode() {
            int hash = state;
            for (int i = 0; i < variables.length; i++) {
                hash = 31 * hash + variables[i].hashCode();
            }
            return hash;
        }
    }

    private final String requirement;
    private final String[] states;
    private final String[] ports;
    private final boolean[] delayed;
    private ArrayList<Run> runs = new ArrayList<Run>();
    private String problem = "";
    private boolean satisfied;
    private int slice;
    private String violation = "";

    /**
     * @param requirement its name, with the line of the model
     * @param states their names; empty if there are too many
     * @param ports names of the outputs
     * @param delayed whether an output shows the reaction to a slice in the next one
     */
    protected Monitor(String requirement, String[] states, String[] ports, boolean[] delayed) {
        this.requirement = requirement;
        this.states = states;
        this.ports = ports;
        this.delayed = delayed;
    }

    /** What the outputs show in this slice, {@link #SILENCE} for no message. */
    protected abstract Object[] seen();

    /** Calls {@link #go} for each transition that is enabled. */
    protected abstract void react(int state, Object[] variables);

    /** Calls {@link #go} where no transition is enabled, unless that is forbidden. */
    protected abstract void complete(int state, Object[] variables);

    /** Says that a run may go on, or begin, like this. */
    protected final void go(String cause, int state, Object[] variables, Object... promises) {
        runs.add(new Run(cause, state, variables, promises));
    }

    /** Values of variables. */
    protected static Object[] values(Object... values) {
        return values;
    }

    /** The name of a state. */
    protected final String name(int state) {
        return state < states.length ? states[state] : String.valueOf(state);
    }

    /**
     * Judges the slice that the ports show.
     *
     * @return false if the requirement is violated, now or since an earlier slice
     */
    public final boolean slice() {
        if (!satisfied && violation.length() == 0) {
            Object[] seen = messages();
            keep(seen, true);
            settle();
            if (!satisfied && violation.length() == 0) {
                step();
                keep(seen, false);
            }
        }
        slice++;
        return violation.length() == 0;
    }

    /** What is seen; whoever sets a port that always has a message to none is heard, too. */
    private Object[] messages() {
        Object[] messages = seen();
        for (int i = 0; i < messages.length; i++) {
            messages[i] = messages[i] == null ? SILENCE : messages[i];
        }
        return messages;
    }

    /** Keeps the runs whose promises agree with what is seen. */
    private void keep(Object[] seen, boolean late) {
        ArrayList<Run> kept = new ArrayList<Run>();
        for (int i = 0; i < runs.size(); i++) {
            if (agrees(runs.get(i), seen, late)) {
                kept.add(runs.get(i));
            }
        }
        if (kept.size() == 0) {
            violation = "slice " + slice + ": " + requirement + accusation(seen, late);
        }
        runs = kept;
    }

    private boolean agrees(Run run, Object[] seen, boolean late) {
        for (int port = 0; port < ports.length; port++) {
            if (delayed[port] == late && !allows(run.promises[port], seen[port])) {
                return false;
            }
        }
        return true;
    }

    private static boolean allows(Object promise, Object seen) {
        return promise == ANYTHING
                || (promise == ANY_MESSAGE ? seen != SILENCE : promise.equals(seen));
    }

    /** Runs that are at the same place are one run from here on. */
    private void settle() {
        ArrayList<Run> different = new ArrayList<Run>();
        HashSet<Run> known = new HashSet<Run>();
        for (int i = 0; i < runs.size(); i++) {
            satisfied |= runs.get(i).state == CHAOS;
            if (known.add(runs.get(i))) {
                different.add(runs.get(i));
            }
        }
        runs = different;
    }

    private void step() {
        ArrayList<Run> before = runs;
        runs = new ArrayList<Run>();
        for (int i = 0; i < before.size(); i++) {
            Run run = before.get(i);
            int count = runs.size();
            try {
                react(run.state, run.variables);
                if (runs.size() == count) {
                    problem = " forbids this input in " + name(run.state);
                    complete(run.state, run.variables);
                }
            } catch (ModelError error) {
                problem = " goes wrong: " + error.getMessage();
                while (runs.size() > count) {
                    runs.remove(runs.size() - 1);
                }
            }
        }
    }

    private String accusation(Object[] seen, boolean late) {
        if (runs.size() == 0) {
            return problem;
        }
        ArrayList<String> shown = new ArrayList<String>();
        for (int port = 0; port < ports.length; port++) {
            if (judges(port, late)) {
                shown.add(ports[port] + " = " + text(seen[port]));
            }
        }
        ArrayList<String> allowed = new ArrayList<String>();
        for (int i = 0; i < runs.size(); i++) {
            String alternative = alternative(runs.get(i), late);
            if (!allowed.contains(alternative)) {
                allowed.add(alternative);
            }
        }
        return " forbids " + joined(shown, ", ") + "; it allows " + joined(allowed, " or ");
    }

    /** Whether any run says something about a port. */
    private boolean judges(int port, boolean late) {
        boolean said = false;
        for (int i = 0; i < runs.size(); i++) {
            said |= runs.get(i).promises[port] != ANYTHING;
        }
        return said && delayed[port] == late;
    }

    private String alternative(Run run, boolean late) {
        ArrayList<String> promised = new ArrayList<String>();
        for (int port = 0; port < ports.length; port++) {
            if (judges(port, late)) {
                promised.add(ports[port] + " = " + text(run.promises[port]));
            }
        }
        return joined(promised, ", ") + " (" + run.cause + ")";
    }

    private static String joined(ArrayList<String> texts, String separator) {
        String joined = "";
        for (int i = 0; i < texts.size(); i++) {
            joined += (i == 0 ? "" : separator) + texts.get(i);
        }
        return joined;
    }

    /** As models write it, on one line. */
    private static String text(Object message) {
        if (message instanceof String) {
            return quoted((String) message, '"');
        }
        return message instanceof Character ? quoted(message.toString(), '\'') : message.toString();
    }

    private static String quoted(String text, char quote) {
        StringBuilder quoted = new StringBuilder();
        quoted.append(quote);
        for (int i = 0; i < text.length(); i++) {
            char c = text.charAt(i);
            int escaped = "\n\r\t\\".indexOf(c);
            if (escaped >= 0) {
                quoted.append('\\').append("nrt\\".charAt(escaped));
            } else {
                quoted.append(c == quote ? "\\" : "").append(c);
            }
        }
        return quoted.append(quote).toString();
    }

    /**
     * What was violated, in which slice, and what would have been allowed; empty if nothing was.
     */
    public final String violation() {
        return violation;
    }

    /** Whether the requirement promises nothing any more. */
    public final boolean isSatisfied() {
        return satisfied;
    }
}
