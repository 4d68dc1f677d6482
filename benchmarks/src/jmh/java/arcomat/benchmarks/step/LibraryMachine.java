package arcomat.benchmarks.step;

/** Fig. 6 inside a library for state machines. */
abstract class LibraryMachine {
    /** What was sent in the last step, coded. */
    protected int cmd;

    protected int timerCmd;

    /** Makes one step. */
    final void step(int letter) {
        cmd = 0;
        timerCmd = 0;
        fire(letter);
    }

    protected abstract void fire(int letter);

    protected final void send(Rule rule) {
        cmd = rule.cmd();
        timerCmd = rule.timerCmd();
    }
}
