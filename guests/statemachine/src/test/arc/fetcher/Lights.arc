package fetcher;

import fetcher.Robot.*;

/** Red and green take turns. */
component Lights {
    port
        in Distance front,
        in Boolean cup,
        in Button button,
        out MotorCmd cmd,
        out Lamp lamp;

    <<omitted = "free">> automaton {
        state working, paused;

        initial working / {lamp = green};

        working / {lamp = --};
        working -> paused / {lamp = red};
        paused / {lamp = --};
        paused -> working / {lamp = green};
    }
}
