package arcomat.rt;

/**
 * Watches an event-driven component for one requirement. Its {@link #border} sees what the outputs
 * send. Call {@link #slice} after the component has started, and then after each event, with the
 * message of that event on its port and none on the ports of other events. Latched ports keep what
 * they hold. An event that the requirement has no port for counts, too: then no port has one.
 */
public abstract class EventMonitor extends Monitor {
    private final SentMessages sent;
    private boolean begun;

    /**
     * @param requirement its name, with the line of the model
     * @param states their names; empty if there are too many
     * @param variables how many there are
     * @param ports names of the outputs
     */
    protected EventMonitor(String requirement, String[] states, int variables, String[] ports) {
        super("event", requirement, states, variables, ports, new boolean[ports.length]);
        sent = new SentMessages(ports);
    }

    /** Whether one of the ports has an event. */
    protected abstract boolean hasEvent();

    /** What sees all that the outputs send: put it into the component. */
    public final Border border() {
        return sent;
    }

    /** A border that tells all of these. */
    public static Border shared(Border... borders) {
        return new SharedBorder(borders);
    }

    @Override
    protected final void see() {
        sent.showTo(seen);
    }

    @Override
    final boolean isHandled() {
        return hasEvent();
    }

    /**
     * Judges what was sent since the last call: first what the component has begun with, then what
     * has followed from each event.
     *
     * @return false if the requirement is violated, now or since an earlier event
     */
    @Override
    public final boolean slice() {
        boolean kept;
        if (begun) {
            kept = super.slice();
        } else if (hasEvent()) {
            throw new IllegalStateException("slice() is to be called before the first event, too");
        } else {
            begun = true;
            kept = begin();
        }
        sent.forget();
        return kept;
    }

    /**
     * Judges that the program has ended with an error: at the beginning, or after this event. What
     * it sent in between is not looked at.
     *
     * @return false if the requirement is violated, now or since an earlier event
     */
    @Override
    public final boolean error() {
        sent.forget();
        return begun ? super.error() : errorBefore();
    }
}
