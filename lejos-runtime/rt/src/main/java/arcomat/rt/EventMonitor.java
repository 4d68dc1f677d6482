package arcomat.rt;

import java.util.ArrayList;

/**
 * Watches an event-driven component for one requirement. Its {@link #border} sees what the outputs
 * send. Call {@link #slice} after the component has started, and then after each event, with the
 * message of that event on its port and none on the ports of other events. Latched ports keep what
 * they hold. An event that the requirement has no port for counts, too: then no port has one.
 */
public abstract class EventMonitor extends Monitor {
    private final String[] ports;
    private final ArrayList<ArrayList<Object>> sent = new ArrayList<ArrayList<Object>>();
    private boolean begun;

    private final Border border =
            new Boxing() {
                @Override
                void note(String port, Object message) {
                    keep(port, message);
                }
            };

    /** Takes messages as objects. */
    private abstract static class Boxing extends Border {
        abstract void note(String port, Object message);

        @Override
        public final void sent(String port, int message) {
            note(port, Integer.valueOf(message));
        }

        @Override
        public final void sent(String port, long message) {
            note(port, Long.valueOf(message));
        }

        @Override
        public final void sent(String port, boolean message) {
            note(port, Boolean.valueOf(message));
        }

        @Override
        public final void sent(String port, char message) {
            note(port, Character.valueOf(message));
        }

        @Override
        public final void sent(String port, double message) {
            note(port, Double.valueOf(message));
        }

        @Override
        public final void sent(String port, Object message) {
            note(port, message);
        }
    }

    /**
     * @param requirement its name, with the line of the model
     * @param states their names; empty if there are too many
     * @param ports names of the outputs
     */
    protected EventMonitor(String requirement, String[] states, String[] ports) {
        super("event", requirement, states, ports, new boolean[ports.length]);
        this.ports = ports;
        for (int i = 0; i < ports.length; i++) {
            sent.add(new ArrayList<Object>());
        }
    }

    /** Whether one of the ports has an event. */
    protected abstract boolean hasEvent();

    /**
     * A message as the requirement names it.
     *
     * @param port position of the output
     */
    protected Object message(int port, Object message) {
        return message;
    }

    /** Messages that are sent one after the other. */
    protected static Object several(Object... messages) {
        return new Several(messages);
    }

    /** What sees all that the outputs send: put it into the component. */
    public final Border border() {
        return border;
    }

    /** A border that tells all of these. */
    public static Border shared(final Border... borders) {
        return new Boxing() {
            @Override
            void note(String port, Object message) {
                for (int i = 0; i < borders.length; i++) {
                    borders[i].sent(port, message);
                }
            }
        };
    }

    private void keep(String port, Object message) {
        for (int i = 0; i < ports.length; i++) {
            if (ports[i].equals(port)) {
                sent.get(i).add(message(i, message));
            }
        }
    }

    @Override
    protected final Object[] seen() {
        Object[] seen = new Object[ports.length];
        for (int i = 0; i < seen.length; i++) {
            ArrayList<Object> messages = sent.get(i);
            seen[i] =
                    messages.size() == 0
                            ? SILENCE
                            : messages.size() == 1
                                    ? messages.get(0)
                                    : new Several(messages.toArray());
        }
        return seen;
    }

    private void forget() {
        for (int i = 0; i < ports.length; i++) {
            sent.get(i).clear();
        }
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
        forget();
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
        forget();
        return begun ? super.error() : errorBefore();
    }
}
