package fetcher;

import fetcher.Robot.*;

/**
 * Fetches coffee, makes room for others on the way there, and waits for them on the way back. A
 * press stops it, and the next one lets it go on where it was.
 */
component Fetcher {
    port
        in Distance front,
        in Boolean cup,
        in Button button,
        out MotorCmd cmd,
        out Lamp lamp;

    <<completion = "ignore">> statemachine {
        initial working;

        state working {
            entry / {lamp = green};
            exit / {lamp = red};

            initial fetching;

            state fetching {
                initial driving;

                state driving { entry / {cmd = fwd}; }
                state aside { entry / {cmd = backRight}; }

                driving -> aside {front == tooClose};
                aside -> driving {front == clear};
            }

            state bringing {
                initial carrying;

                state carrying { entry / {cmd = fwd}; }
                state waiting { entry / {cmd = stop}; }

                carrying -> waiting {front == tooClose};
                waiting -> carrying {front == clear};
            }

            fetching -> bringing {cup == true};
            bringing -> fetching {cup == false};
        }

        state paused { entry / {cmd = stop}; }

        working -> paused {button == press};
        paused -> working.deepHistory {button == press};
    }
}
