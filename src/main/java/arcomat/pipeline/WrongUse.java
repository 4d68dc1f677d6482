package arcomat.pipeline;

/**
 * What was asked for cannot be done as asked. The message says what is wrong and what to do; it is
 * all that the user needs to see.
 */
public final class WrongUse extends Exception {
    private static final long serialVersionUID = 1L;

    /**
     * @param message what is wrong, and what to do; with arguments, a format for them
     */
    public WrongUse(String message, Object... arguments) {
        super(arguments.length == 0 ? message : message.formatted(arguments));
    }

    @Override
    public String getMessage() {
        return String.valueOf(super.getMessage());
    }
}
