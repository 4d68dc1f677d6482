package arcomat.benchmarks.network;

/** A small component, by hand: it passes on what it gets and adds one to every other message. */
final class Stage {
    boolean hasInput;
    int input;

    boolean hasOutput;
    int output;

    private int state;

    void step() {
        switch (state) {
            case 0:
                if (hasInput) {
                    output = input + 1;
                    hasOutput = true;
                    state = 1;
                    return;
                }
                break;
            case 1:
                if (hasInput) {
                    output = input;
                    hasOutput = true;
                    state = 0;
                    return;
                }
                break;
            default:
                throw new IllegalStateException();
        }
        hasOutput = false;
    }
}
