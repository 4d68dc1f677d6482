package coffee.floor;

import coffee.types.Types.*;

/**
 * Fig. 6, with a window: it says what it is doing, for the display of the brick. What it does is
 * the same, so it keeps the promise of Fig. 6 and of all before.
 */
component AvoidCrash refines coffee.fig6.AvoidCrash {
    port
        in Distance frontUS,
        in TimerSignal timerSig,
        in LineStatus ls,
        <<total>> in Boolean gotCoffee,
        out MotorCmd cmd,
        out TimerCmd timerCmd,
        out String doing;

    <<completion = "ignore">> automaton {
        state driving, backing, waiting, remote, returning;

        initial driving / {cmd = fwd, doing = "driving"};

        driving -> backing {frontUS == tooClose, gotCoffee == false}
                / {cmd = backRight, timerCmd = delay, doing = "backing"};
        driving -> waiting {frontUS == tooClose, gotCoffee == true}
                / {cmd = stop, doing = "waiting"};
        waiting -> driving {frontUS == clear} / {cmd = fwd, doing = "driving"};

        backing -> remote {timerSig == alert} / {cmd = stop, doing = "remote"};
        remote -> returning {frontUS == clear} / {cmd = fwd, doing = "returning"};
        returning -> driving {ls == ok} / {doing = "driving"};
    }
}
