package yard;

import nxt.LcdLogger;
import yard.Lights.*;

/** Is on from one slice to another, and says so: at once, and a slice later. */
component Beacon(Integer from, Integer to) {
    component LcdLogger(0) display;
    component Lamp(from, to) lamp;
    component Echo echo;

    component Lamp(Integer from, Integer to) {
        timing instant;

        port out Light light, out String doing;

        automaton {
            state counting;

            variable Integer slice = 0;

            initial counting;

            counting [slice == from] / {light = on, doing = "on", slice = slice + 1};
            counting [slice == to] / {light = off, doing = "off", slice = slice + 1};
            counting [slice != from && slice != to] / {slice = slice + 1};
        }
    }

    component Echo {
        port in Light light, out Light later;

        <<completion = "ignore">> automaton {
            state hearing;

            initial hearing;

            hearing {light == on} / {later = on};
            hearing {light == off} / {later = off};
        }
    }

    connect lamp.light -> echo.light;
    connect lamp.doing -> display.text;
}
