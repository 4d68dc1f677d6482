package arcomat.benchmarks.step;

/** Fig. 6 as most people write it: enums in fields, null for no message, a switch over an enum. */
final class EnumSwitch {
    enum State {
        DRIVING,
        BACKING,
        WAITING,
        REMOTE,
        RETURNING
    }

    enum Distance {
        CLEAR,
        TOO_CLOSE
    }

    enum TimerSignal {
        ALERT
    }

    enum LineStatus {
        OK,
        LOST
    }

    enum MotorCmd {
        FWD,
        STOP,
        BACK_RIGHT
    }

    enum TimerCmd {
        DELAY
    }

    Distance frontUS;
    TimerSignal timerSig;
    LineStatus ls;
    Boolean gotCoffee;

    MotorCmd cmd;
    TimerCmd timerCmd;

    private State state = State.DRIVING;

    void step() {
        cmd = null;
        timerCmd = null;
        switch (state) {
            case DRIVING:
                if (frontUS == Distance.TOO_CLOSE && !gotCoffee) {
                    cmd = MotorCmd.BACK_RIGHT;
                    timerCmd = TimerCmd.DELAY;
                    state = State.BACKING;
                } else if (frontUS == Distance.TOO_CLOSE && gotCoffee) {
                    cmd = MotorCmd.STOP;
                    state = State.WAITING;
                }
                break;
            case BACKING:
                if (timerSig == TimerSignal.ALERT) {
                    cmd = MotorCmd.STOP;
                    state = State.REMOTE;
                }
                break;
            case WAITING:
                if (frontUS == Distance.CLEAR) {
                    cmd = MotorCmd.FWD;
                    state = State.DRIVING;
                }
                break;
            case REMOTE:
                if (frontUS == Distance.CLEAR) {
                    cmd = MotorCmd.FWD;
                    state = State.RETURNING;
                }
                break;
            case RETURNING:
                if (ls == LineStatus.OK) {
                    state = State.DRIVING;
                }
                break;
            default:
                throw new IllegalStateException();
        }
    }
}
