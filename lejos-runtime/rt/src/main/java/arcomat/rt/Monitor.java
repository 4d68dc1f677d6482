package arcomat.rt;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;

/**
 * Watches the ports of a component for one requirement. A requirement may allow several runs; the
 * monitor follows all of those that agree with what was seen, and when none is left the requirement
 * is violated. What is compared is what is visible in a slice, whatever the delays of what runs.
 *
 * <p>What a requirement asks for is in the generated class below this one. Whoever uses it sets the
 * ports to what is visible in a slice, then calls {@link #slice}.
 */
public abstract class Monitor {
    /** The state after an input that leaves everything open. */
    protected static final int CHAOS = -1;

    /** With more, the set of runs grows beyond what can be followed. */
    private static final int MOST_RUNS = 100000;

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

    /** What is promised about a port that sends several messages after an event. */
    static final class Several {
        final Object[] messages;

        Several(Object[] messages) {
            this.messages = messages;
        }

        @Override
        public boolean equals(Object other) {
            return other instanceof Several && Arrays.equals(messages, ((Several) other).messages);
        }

        @Override
        public int hashCode() {
            return hash(messages);
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
            return state == that.state
                    && (state == CHAOS || Arrays.equals(variables, that.variables));
        }

        @Override
        public int hashCode() {
            return state == CHAOS ? state : 31 * hash(variables) + state;
        }
    }

    private static int hash(Object[] objects) {
        int hash = 1;
        for (int i = 0; i < objects.length; i++) {
            hash = 31 * hash + objects[i].hashCode();
        }
        return hash;
    }

    private final String unit;
    private final String requirement;
    private final String[] states;
    private final String[] ports;
    private final boolean[] delayed;

    /** Whether any output shows the reaction to a slice in the same one. */
    private final boolean prompt;

    private ArrayList<Run> runs = new ArrayList<Run>();

    /** Why the requirement may have ended in an error in the last step; empty if it may not. */
    private String error = "";

    private boolean satisfied;

    /** Whether runs have been given up that only matter where the program ends in an error. */
    private boolean lost;

    private int slice;
    private String violation = "";
    private String unknown = "";

    /**
     * @param requirement its name, with the line of the model
     * @param states their names; empty if there are too many
     * @param ports names of the outputs
     * @param delayed whether an output shows the reaction to a slice in the next one
     */
    protected Monitor(String requirement, String[] states, String[] ports, boolean[] delayed) {
        this("slice", requirement, states, ports, delayed);
    }

    Monitor(String unit, String requirement, String[] states, String[] ports, boolean[] delayed) {
        this.unit = unit;
        this.requirement = requirement;
        this.states = states;
        this.ports = ports;
        this.delayed = delayed;
        boolean any = false;
        for (int i = 0; i < delayed.length; i++) {
            any |= !delayed[i];
        }
        prompt = any || !unit.equals("slice");
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

    /** Says that a transition, if it could be taken, would go wrong. */
    protected final void goesWrong(ModelError problem) {
        mayEnd("it goes wrong: " + problem.getMessage());
    }

    private void mayEnd(String why) {
        if (error.length() == 0) {
            error = " allows only an error in " + unit + " " + slice + ": " + why;
        }
    }

    /**
     * Judges the slice that the ports show.
     *
     * @return false if the requirement is violated, now or since an earlier slice
     */
    public boolean slice() {
        if (!isSettled()) {
            judge(messages());
        }
        slice++;
        return violation.length() == 0;
    }

    private boolean isSettled() {
        return violation.length() > 0 || unknown.length() > 0;
    }

    private void judge(Object[] seen) {
        if (goesOn() && keep(seen, true)) {
            settle();
            step();
            if (prompt && !isSettled() && goesOn()) {
                keep(seen, false);
            }
        }
    }

    /**
     * Judges what the outputs show before the first step.
     *
     * @return false if the requirement is violated
     */
    final boolean begin() {
        if (!isSettled()) {
            keep(messages(), false);
        }
        return violation.length() == 0;
    }

    /** Judges that the program has ended with an error before its first step. */
    final boolean errorBefore() {
        if (!isSettled()) {
            violate(" forbids that the run begins with an error");
        }
        return false;
    }

    /**
     * Judges that the program has ended with an error in the slice that the ports show: outputs
     * with delay 1 what was sent before, those without delay nothing.
     *
     * @return false if the requirement is violated, now or since an earlier slice
     */
    public boolean error() {
        if (!isSettled()) {
            judgeError(messages());
        }
        slice++;
        return violation.length() == 0;
    }

    private void judgeError(Object[] seen) {
        if (!goesOn() || !keep(seen, true)) {
            return;
        }
        settle();
        step();
        boolean mayEnd = lost || error.length() > 0;
        String sent = sentAtOnce(seen);
        if (sent.length() > 0 && mayEnd) {
            unknown = "";
            violate(" forbids " + sent + " in the slice of an error");
        } else if (error.length() > 0) {
            unknown = "";
        } else if (lost) {
            unknown = tooMany();
        } else if (unknown.length() == 0) {
            violate(" forbids that the run ends in an error");
        }
    }

    /** What outputs without delay show, as {@code y = 1, z = 2}. */
    private String sentAtOnce(Object[] seen) {
        ArrayList<String> sent = new ArrayList<String>();
        for (int port = 0; port < ports.length; port++) {
            if (!delayed[port] && seen[port] != SILENCE) {
                sent.add(ports[port] + " = " + text(seen[port]));
            }
        }
        return joined(sent, ", ");
    }

    /** Where the program goes on, it has not ended in an error; the requirement may have had to. */
    private boolean goesOn() {
        if (runs.size() == 0) {
            violate(error);
        }
        return runs.size() > 0;
    }

    private void violate(String text) {
        violation = unit + " " + slice + ": " + requirement + text;
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
    private boolean keep(Object[] seen, boolean late) {
        ArrayList<Run> kept = new ArrayList<Run>();
        for (int i = 0; i < runs.size(); i++) {
            if (agrees(runs.get(i), seen, late)) {
                kept.add(runs.get(i));
            }
        }
        if (kept.size() == 0) {
            violate(accusation(seen, late));
        }
        runs = kept;
        return kept.size() > 0;
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
                || (promise == ANY_MESSAGE
                        ? seen != SILENCE && !(seen instanceof Several)
                        : promise.equals(seen));
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

    /** Each transition that is enabled is a way to go on; one that goes wrong ends the run. */
    private void step() {
        ArrayList<Run> before = runs;
        runs = new ArrayList<Run>();
        error = "";
        for (int i = 0; i < before.size(); i++) {
            step(before.get(i));
            if (runs.size() > MOST_RUNS) {
                giveUp(before);
                return;
            }
        }
    }

    private void step(Run run) {
        if (run.state == CHAOS) {
            String cause = "no transition fits in chaos, completion chaos";
            runs.add(new Run(cause, CHAOS, run.variables, run.promises));
            return;
        }
        int count = runs.size();
        String known = error;
        error = "";
        if (isHandled()) {
            react(run.state, run.variables);
        }
        if (runs.size() == count && error.length() == 0) {
            complete(run.state, run.variables);
            if (runs.size() == count) {
                mayEnd("it forbids this input in " + name(run.state));
            }
        }
        error = known.length() > 0 ? known : error;
    }

    /** Whether there is an input that a transition may handle. */
    boolean isHandled() {
        return true;
    }

    /** Where everything is allowed from here on, the other runs matter only for an error. */
    private void giveUp(ArrayList<Run> before) {
        before.addAll(runs);
        Run chaos = null;
        for (int i = 0; i < before.size() && chaos == null; i++) {
            chaos = before.get(i).state == CHAOS ? before.get(i) : null;
        }
        runs = new ArrayList<Run>();
        lost = true;
        if (chaos == null) {
            unknown = tooMany();
        } else {
            runs.add(chaos);
        }
    }

    private String tooMany() {
        return "more than " + MOST_RUNS + " ways to go on in " + unit + " " + slice;
    }

    private String accusation(Object[] seen, boolean late) {
        boolean[] said = new boolean[ports.length];
        ArrayList<String> shown = new ArrayList<String>();
        for (int port = 0; port < ports.length; port++) {
            said[port] = delayed[port] == late && isPromised(port);
            if (said[port]) {
                shown.add(ports[port] + " = " + text(seen[port]));
            }
        }
        ArrayList<String> allowed = new ArrayList<String>();
        for (int i = 0; i < runs.size(); i++) {
            String alternative = alternative(runs.get(i), said);
            if (!allowed.contains(alternative)) {
                allowed.add(alternative);
            }
        }
        return " forbids " + joined(shown, ", ") + "; it allows " + joined(allowed, " or ");
    }

    /** Whether any run says something about a port. */
    private boolean isPromised(int port) {
        boolean said = false;
        for (int i = 0; i < runs.size(); i++) {
            said |= runs.get(i).promises[port] != ANYTHING;
        }
        return said;
    }

    private String alternative(Run run, boolean[] said) {
        ArrayList<String> promised = new ArrayList<String>();
        for (int port = 0; port < ports.length; port++) {
            if (said[port]) {
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
        if (message instanceof Several) {
            ArrayList<String> texts = new ArrayList<String>();
            Object[] messages = ((Several) message).messages;
            for (int i = 0; i < messages.length; i++) {
                texts.add(text(messages[i]));
            }
            return joined(texts, ", ");
        }
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

    /** Why it cannot be said whether the requirement is kept; empty if it can. */
    public final String unknown() {
        return unknown;
    }

    /** Whether the requirement promises nothing any more, but that there be no error. */
    public final boolean isSatisfied() {
        return satisfied;
    }
}
