package arcomat.semantics.value;

/** There are too many ways through statements to look at each, and values do not say it shorter. */
public final class TooManyWays extends GivenUp {
    public static final String REASON =
            "too many ways through statements, or too large values, to look at all of them";

    private static final long serialVersionUID = 1L;

    public TooManyWays() {
        super(REASON);
    }
}
