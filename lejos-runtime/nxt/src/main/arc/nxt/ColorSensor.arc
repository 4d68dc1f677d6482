package nxt;

import nxt.Brick.*;

/**
 * The colour sensor with its own lamp on, sampled once per slice. It knows the colours of LEGO
 * bricks, from a distance of about 1 cm.
 */
<<platform, layer = "sensors">> component ColorSensor(SensorPort socket) {
    port <<total>> out Color color;
}
