package arcomat.rt;

/** Why a requirement may end in an error: the first reason of a step. */
final class Ending {
    private static final int NOT = 0;
    private static final int FORBIDDEN = 1;
    private static final int WRONG = 2;

    private int reason;

    /** How many reasons there were. */
    private int count;

    private int slice;
    private int state;
    private final Careful mistake = new Careful();

    /** A further step begins. */
    void forget() {
        reason = NOT;
        count = 0;
    }

    int count() {
        return count;
    }

    boolean isPossible() {
        return reason != NOT;
    }

    /** The input is forbidden in a state. */
    void forbid(int where, int when) {
        if (reason == NOT) {
            reason = FORBIDDEN;
            state = where;
            slice = when;
        }
        count++;
    }

    /** A transition, if it could be taken, would go wrong. */
    void goesWrong(Careful what, int when) {
        if (reason == NOT) {
            reason = WRONG;
            mistake.become(what);
            slice = when;
        }
        count++;
    }

    String text(Requirement requirement, String unit) {
        return reason == NOT
                ? ""
                : " allows only an error in "
                        + unit
                        + " "
                        + slice
                        + ": "
                        + (reason == FORBIDDEN
                                ? "it forbids this input in " + requirement.name(state)
                                : "it goes wrong: " + mistake.text());
    }
}
