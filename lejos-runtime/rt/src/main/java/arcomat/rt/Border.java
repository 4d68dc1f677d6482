package arcomat.rt;

/**
 * Sees the messages that leave an event-driven program: those on the outputs of the whole and those
 * that reach platform components. One method per kind of message, so that nothing is boxed.
 */
public abstract class Border {
    /** A whole number, or the code of an enum's constant. */
    public abstract void sent(String port, int message);

    public abstract void sent(String port, long message);

    public abstract void sent(String port, boolean message);

    public abstract void sent(String port, char message);

    public abstract void sent(String port, double message);

    /** A string or an object of a class diagram's class. */
    public abstract void sent(String port, Object message);
}
