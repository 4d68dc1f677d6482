package arcomat.benchmarks.network;

/** Chains of stages as objects in arrays, called in a loop. */
final class ObjectNetwork implements Network {
    private final Stage[][] chains;

    ObjectNetwork(Shape shape) {
        chains = new Stage[shape.chains()][shape.length()];
        for (Stage[] chain : chains) {
            for (int i = 0; i < chain.length; i++) {
                chain[i] = new Stage();
            }
        }
    }

    @Override
    public int run(int[] messages) {
        int sum = 0;
        for (int message : messages) {
            int sent = 0;
            for (Stage[] chain : chains) {
                sent += slice(chain, message);
            }
            sum = sum * 31 + sent;
        }
        return sum;
    }

    /** Back to front: an output can be handed on at once and is read a slice later. */
    private static int slice(Stage[] chain, int message) {
        int last = chain.length - 1;
        for (int i = last; i >= 0; i--) {
            Stage stage = chain[i];
            if (i == 0) {
                stage.hasInput = message != 0;
                stage.input = message;
            }
            stage.step();
            if (i < last) {
                chain[i + 1].hasInput = stage.hasOutput;
                chain[i + 1].input = stage.output;
            }
        }
        return chain[last].hasOutput ? chain[last].output : 0;
    }
}
