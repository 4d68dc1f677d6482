package nxt;

import nxt.Brick.SensorPort;

/**
 * The light sensor with its own lamp on, sampled once per slice: it sees how much a surface close
 * to it reflects.
 *
 * dark, bright: the readings that count as 0 and 100 percent, as the sensor gives them, 0 to
 * 1023. A robot that is to see a line well gives those of the line and of the floor, and so needs
 * less than the whole range; typical are 300 and 600.
 */
<<platform, layer = "sensors">> component LightSensor(SensorPort socket, Integer[0..1023] dark = 0,
        Integer[0..1023] bright = 1023) {
    /**
     * Brightness in percent between dark and bright. Readings beyond either end count as that
     * end: the sensor itself was seen to report 123 and -77.
     */
    port <<total>> out Integer[0..100] value;
}
