package arcomat.benchmarks.network;

/** Chains of stages as numbers in arrays: about the least that the machine can do. */
final class ArrayNetwork implements Network {
    private final Shape shape;
    private final boolean[] hasMessage;
    private final int[] messages;
    private final boolean[] odd;

    ArrayNetwork(Shape shape) {
        this.shape = shape;
        hasMessage = new boolean[shape.parts()];
        messages = new int[shape.parts()];
        odd = new boolean[shape.parts()];
    }

    @Override
    public int run(int[] inputs) {
        int sum = 0;
        for (int input : inputs) {
            int sent = 0;
            for (int first = 0; first < messages.length; first += shape.length()) {
                sent += slice(first, first + shape.length() - 1, input);
            }
            sum = sum * 31 + sent;
        }
        return sum;
    }

    /** What a part sends takes the place of what it sent in the slice before, back to front. */
    private int slice(int first, int last, int input) {
        for (int i = last; i > first; i--) {
            step(i, hasMessage[i - 1], messages[i - 1]);
        }
        step(first, input != 0, input);
        return hasMessage[last] ? messages[last] : 0;
    }

    private void step(int part, boolean hasInput, int input) {
        hasMessage[part] = hasInput;
        if (hasInput) {
            messages[part] = odd[part] ? input : input + 1;
            odd[part] = !odd[part];
        }
    }
}
