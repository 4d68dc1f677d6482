package fetcher;

import fetcher.Robot.*;

/** Makes room for others, blinks meanwhile, and always hears the button. */
component Obedient {
    port
        in Distance front,
        in Boolean cup,
        in Button button,
        out MotorCmd cmd,
        out Lamp lamp;

    <<completion = "ignore">> statemachine {
        priority outer;

        initial working;

        state working {
            do / {lamp = green};

            initial driving;

            state driving { entry / {cmd = fwd}; }
            state aside { entry / {cmd = backRight}; }

            driving -> aside {front == tooClose};
            aside -> driving {front == clear};
        }

        state paused { entry / {cmd = stop}; }

        working -> paused {button == press};
        paused -> working.history {button == press};
    }
}
