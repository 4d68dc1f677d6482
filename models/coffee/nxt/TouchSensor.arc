package nxt;

import nxt.Brick.SensorPort;

/** The push button sensor of the NXT, sampled once per slice. */
<<platform, layer = "sensors">> component TouchSensor(SensorPort socket) {
    port <<total>> out Boolean pressed;
}
