package shop;

import shop.Shop.*;

/** How fast a wheel turns. */
component Gear {
    port in Command command, out Integer speed;

    <<completion = "ignore">> automaton {
        state idle;

        initial idle;

        idle -> idle {command == go} / {speed = 360};
        idle -> idle {command == halt} / {speed = 0};
    }
}
