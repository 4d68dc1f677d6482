package arcomat.benchmarks.step;

/** Fig. 6 as a careful programmer writes it for speed: everything an int, one switch. */
final class IntSwitch {
    static final int DRIVING = 0;
    static final int BACKING = 1;
    static final int WAITING = 2;
    static final int REMOTE = 3;
    static final int RETURNING = 4;

    static final int CLEAR = 1;
    static final int TOO_CLOSE = 2;
    static final int ALERT = 1;
    static final int OK = 1;

    static final int FWD = 1;
    static final int STOP = 2;
    static final int BACK_RIGHT = 3;
    static final int DELAY = 1;

    int frontUS;
    int timerSig;
    int ls;
    boolean gotCoffee;

    int cmd;
    int timerCmd;

    int state = DRIVING;

    void step() {
        cmd = 0;
        timerCmd = 0;
        switch (state) {
            case DRIVING:
                if (frontUS == TOO_CLOSE && !gotCoffee) {
                    cmd = BACK_RIGHT;
                    timerCmd = DELAY;
                    state = BACKING;
                } else if (frontUS == TOO_CLOSE && gotCoffee) {
                    cmd = STOP;
                    state = WAITING;
                }
                break;
            case BACKING:
                if (timerSig == ALERT) {
                    cmd = STOP;
                    state = REMOTE;
                }
                break;
            case WAITING:
                if (frontUS == CLEAR) {
                    cmd = FWD;
                    state = DRIVING;
                }
                break;
            case REMOTE:
                if (frontUS == CLEAR) {
                    cmd = FWD;
                    state = RETURNING;
                }
                break;
            case RETURNING:
                if (ls == OK) {
                    state = DRIVING;
                }
                break;
            default:
                throw new IllegalStateException();
        }
    }
}
