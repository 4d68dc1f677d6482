package arcomat.rt;

/**
 * The model itself goes wrong while it runs: a value outside its range, a division by zero, a total
 * port without a message, a full queue, a forbidden input. The message names transition, slice and
 * value. The only exception that generated code throws.
 */
public class ModelError extends RuntimeException {
    private static final long serialVersionUID = 1L;

    public ModelError(String message) {
        super(message);
    }
}
