package nxt;

import nxt.Brick.SensorPort;

/** The reflected-light sensor of the NXT, sampled once per slice. */
<<platform, layer = "sensors">> component LightSensor(SensorPort socket) {
    /**
     * Brightness in percent between the calibrated ends, dark 0 and bright 100.
     * Not clamped: the brick was seen to report 123 and -77.
     */
    port <<total>> out Integer value;
}
