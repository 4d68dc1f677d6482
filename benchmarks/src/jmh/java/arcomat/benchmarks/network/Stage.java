package arcomat.benchmarks.network;

/** A small component, by hand: it passes on what it gets and adds one to every other message. */
final class Stage {
    boolean hasInput;
    int input;

    boolean hasOutput;
    int output;

    private boolean odd;

    void step() {
        if (hasInput) {
            output = odd ? input : input + 1;
            hasOutput = true;
            odd = !odd;
        } else {
            hasOutput = false;
        }
    }
}
