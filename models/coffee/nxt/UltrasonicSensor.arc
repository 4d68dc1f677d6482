package nxt;

import nxt.Brick.SensorPort;

/**
 * The ultrasonic distance sensor of the NXT, sampled once per slice.
 * Its behaviour comes from the target: on the brick from the device, in a simulation from outside.
 */
<<platform, layer = "sensors">> component UltrasonicSensor(SensorPort socket) {
    /** To the nearest obstacle, in cm; 255 when nothing is in range. */
    port <<total>> out Integer[0..255] distance;
}
