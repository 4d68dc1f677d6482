package arcomat.semantics.value;

/** A search that cannot be brought to its end, with the reason: the answer is unknown. */
public class GivenUp extends RuntimeException {
    private static final long serialVersionUID = 1L;

    public GivenUp(String reason) {
        super(reason);
    }
}
