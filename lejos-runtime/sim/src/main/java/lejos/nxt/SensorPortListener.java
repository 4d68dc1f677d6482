package lejos.nxt;

/** Is told of a sensor whose raw value has changed. */
public interface SensorPortListener {
    void stateChanged(SensorPort aSource, int aOldValue, int aNewValue);
}
