package nxt;

import nxt.Brick.SensorPort;

/**
 * The ultrasonic distance sensor, sampled once per slice.
 *
 * The device itself measures every 60 ms; in shorter slices, the last distance is seen again.
 */
<<platform, layer = "sensors">> component UltrasonicSensor(SensorPort socket) {
    /**
     * To the nearest obstacle, in cm, good to about 3 cm between 5 and 170. 255: nothing is in
     * range, the echo was lost, or no sensor is plugged in; the device does not tell these apart.
     */
    port <<total>> out Integer[0..255] distance;
}
