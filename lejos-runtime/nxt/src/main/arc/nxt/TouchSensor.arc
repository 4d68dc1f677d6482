package nxt;

import nxt.Brick.SensorPort;

/** The push button sensor, sampled once per slice: a touch between two samples goes unseen. */
<<platform, layer = "sensors">> component TouchSensor(SensorPort socket) {
    port <<total>> out Boolean pressed;
}
