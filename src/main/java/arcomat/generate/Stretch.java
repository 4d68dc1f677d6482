package arcomat.generate;

import arcomat.semantics.network.Composition;

/**
 * Parts of one component that follow each other and live in one array.
 *
 * @param field name of the array
 * @param first position of the first part in the composition
 * @param end position after the last part
 * @param merged whether a part gets every message as late as it may, right before its step
 */
record Stretch(String field, int first, int end, boolean merged) {
    /** The fewest parts for which an array reads better than fields. */
    static final int LEAST = 8;

    int length() {
        return end - first;
    }

    /** What its parts are called in the model. */
    String comment(Composition composition) {
        String second = composition.nodes().get(first + 1).path();
        return composition.nodes().get(first).path()
                + ", "
                + second
                + " .. "
                + composition.nodes().get(end - 1).path();
    }
}
