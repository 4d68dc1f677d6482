package arcomat.sim;

/** Lets any error of a program through methods that declare none. */
final class ProgramFailure {
    private ProgramFailure() {}

    static RuntimeException unwrapped(Throwable error) {
        throw ProgramFailure.<RuntimeException>cast(error);
    }

    @SuppressWarnings({
        "unchecked",
        "TypeParameterUnusedInFormals"
    }) // never checked at run time: that is the point
    private static <E extends Throwable> E cast(Throwable error) throws E {
        throw (E) error;
    }
}
