package lejos.nxt;

/** The listeners of a socket, and what they were told last. */
final class PortListeners implements ListenerCaller {
    private static final int ROOM = 8;
    private static final int PERIOD = 4;
    private static final int USUAL_TOLERANCE = 2;

    private final SensorPort port;
    private final SensorPortListener[] listeners = new SensorPortListener[ROOM];
    private int count;
    private int told;
    private int tolerance = USUAL_TOLERANCE;

    /** Of the brick: a new tolerance counts from the next change on. */
    private int tolerated = USUAL_TOLERANCE;

    PortListeners(SensorPort port) {
        this.port = port;
    }

    void add(SensorPortListener listener) {
        if (count == 0) {
            tolerated = tolerance;
            ListenerThread.OF_INPUTS.watch(this, this::hasChanged, PERIOD);
        }
        listeners[count++] = listener;
    }

    void setTolerance(int newTolerance) {
        tolerance = newTolerance;
    }

    private boolean hasChanged() {
        return Math.abs(port.converted() - told) > tolerated;
    }

    @Override
    public int callListeners() {
        int value = port.socket().observed(port.converted());
        int old = told;
        told = value;
        tolerated = tolerance;
        for (int i = 0; i < count; i++) {
            listeners[i].stateChanged(port, old, value);
        }
        return value;
    }
}
