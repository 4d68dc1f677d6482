package arcomat.rt;

/**
 * Watches the ports of a component for one requirement. A requirement may allow several runs; the
 * monitor follows all of those that agree with what was seen, and when none is left the requirement
 * is violated. What is compared is what is visible in a slice, whatever the delays of what runs.
 *
 * <p>What a requirement asks for is in the generated class below this one. Whoever uses it sets the
 * ports to what is visible in a slice, then calls {@link #slice}. Once it has followed as many runs
 * as there are, that makes no objects until something is violated.
 */
public abstract class Monitor extends Requirement {
    /** With more, the set of runs grows beyond what can be followed. */
    private static final int MOST_RUNS = 100000;

    private final String unit;
    private final boolean[] delayed;

    /** Whether any output shows the reaction to a slice in the same one. */
    private final boolean prompt;

    private int mostRuns = MOST_RUNS;
    private boolean satisfied;

    /** Whether runs have been given up that only matter where the program ends in an error. */
    private boolean lost;

    private String violation = "";
    private String unknown = "";

    /**
     * @param requirement its name, with the line of the model
     * @param states their names; empty if there are too many
     * @param variables how many there are
     * @param ports names of the outputs
     * @param delayed whether an output shows the reaction to a slice in the next one
     */
    protected Monitor(
            String requirement, String[] states, int variables, String[] ports, boolean[] delayed) {
        this("slice", requirement, states, variables, ports, delayed);
    }

    Monitor(
            String unit,
            String requirement,
            String[] states,
            int variables,
            String[] ports,
            boolean[] delayed) {
        super(requirement, states, variables, ports);
        this.unit = unit;
        this.delayed = delayed;
        boolean any = false;
        for (int i = 0; i < delayed.length; i++) {
            any |= !delayed[i];
        }
        prompt = any || !unit.equals("slice");
    }

    /** Gives up with more runs than that; a small machine cannot follow as many as a large one. */
    public final void followAtMost(int runsAtOnce) {
        mostRuns = runsAtOnce;
    }

    /** The name of the requirement, with the line of the model. */
    public final String requirement() {
        return title;
    }

    /**
     * Judges the slice that the ports show.
     *
     * @return false if the requirement is violated, now or since an earlier slice
     */
    public boolean slice() {
        if (!isSettled()) {
            look();
            judge();
        }
        slice++;
        return violation.length() == 0;
    }

    private boolean isSettled() {
        return violation.length() > 0 || unknown.length() > 0;
    }

    private void look() {
        seen.clear();
        seen.add();
        see();
    }

    private void judge() {
        if (goesOn() && keep(true)) {
            step();
            if (prompt && !isSettled() && goesOn()) {
                keep(false);
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
            look();
            keep(false);
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
            look();
            judgeError();
        }
        slice++;
        return violation.length() == 0;
    }

    /**
     * Judges that the program has gone on after the last slice, which nobody looks at any more.
     *
     * @return false if the requirement is violated
     */
    public final boolean end() {
        if (!isSettled()) {
            goesOn();
        }
        return violation.length() == 0;
    }

    private void judgeError() {
        if (!goesOn() || !keep(true)) {
            return;
        }
        step();
        boolean mayEnd = lost || ending.isPossible();
        String sent = new Accusation(this, delayed).sentAtOnce();
        if (sent.length() > 0 && mayEnd) {
            unknown = "";
            violate(" forbids " + sent + " in the slice of an error");
        } else if (ending.isPossible()) {
            unknown = "";
        } else if (lost) {
            unknown = tooMany();
        } else if (unknown.length() == 0) {
            violate(" forbids that the run ends in an error");
        }
    }

    /** Where the program goes on, it has not ended in an error; the requirement may have had to. */
    private boolean goesOn() {
        if (runs.size() == 0) {
            violate(ending.text(this, unit));
        }
        return runs.size() > 0;
    }

    private void violate(String text) {
        violation = unit + " " + slice + ": " + title + text;
    }

    /** Keeps the runs whose promises agree with what is seen. */
    private boolean keep(boolean late) {
        boolean kept = runs.keep(seen, delayed, late);
        if (!kept) {
            violate(new Accusation(this, delayed).unexpected(late));
        }
        return kept;
    }

    /** Each transition that is enabled is a way to go on; one that goes wrong ends the run. */
    private void step() {
        runs.merge();
        satisfied |= runs.chaos() >= 0;
        Runs done = before;
        before = runs;
        runs = done;
        runs.clear();
        ending.forget();
        for (going = 0; going < before.size(); going++) {
            step(before.state(going));
            if (runs.size() > mostRuns) {
                giveUp();
                return;
            }
        }
    }

    private void step(int state) {
        if (state == CHAOS) {
            runs.addSame("chaos", CHAOS, before, going);
            return;
        }
        int count = runs.size();
        int reasons = ending.count();
        if (isHandled()) {
            react(state);
        }
        if (runs.size() == count && ending.count() == reasons) {
            complete(state);
            if (runs.size() == count) {
                ending.forbid(state, slice);
            }
        }
    }

    /** Whether there is an input that a transition may handle. */
    boolean isHandled() {
        return true;
    }

    /** Where everything is allowed from here on, the other runs matter only for an error. */
    private void giveUp() {
        lost = true;
        if (before.chaos() >= 0) {
            int chaos = before.chaos();
            runs.clear();
            runs.addSame(before.cause(chaos), before.origin(chaos), before, chaos);
        } else if (runs.chaos() >= 0) {
            runs.keepOnly(runs.chaos());
        } else {
            runs.clear();
            unknown = tooMany();
        }
    }

    private String tooMany() {
        return "more than " + mostRuns + " ways to go on in " + unit + " " + slice;
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
