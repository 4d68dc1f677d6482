package arcomat.brick.need.flow;

/** Nothing can be said without running the program; the message tells why, and where. */
public final class Unknown extends RuntimeException {
    private static final long serialVersionUID = 1L;

    private final boolean isPlaced;

    /**
     * @param why part of a sentence, after "not known: "
     */
    public Unknown(String why) {
        this(why, false);
    }

    private Unknown(String why, boolean isPlaced) {
        super(why, null, false, false);
        this.isPlaced = isPlaced;
    }

    /** Of a method that is the reason itself. */
    public static Unknown of(MethodName method, String why) {
        return new Unknown(method + " " + why, true);
    }

    /** The same with the method that it was found in; callers of that one add nothing. */
    public Unknown in(MethodName method) {
        return isPlaced ? this : new Unknown(getMessage() + " in " + method, true);
    }
}
