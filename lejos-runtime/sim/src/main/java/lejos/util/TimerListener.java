package lejos.util;

/** Is told of the time. */
public interface TimerListener {
    void timedOut();
}
