package shop;

import shop.Shop.*;

/** Stops at walls. */
component Bumper {
    port in Boolean wall, out Command wheels;

    automaton {
        state driving, standing;

        initial driving / {wheels = go};

        driving -> standing {wall == true} / {wheels = halt};
        standing -> driving {wall == false} / {wheels = go};
    }
}
