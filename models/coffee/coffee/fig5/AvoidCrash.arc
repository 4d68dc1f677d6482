package coffee.fig5;

import coffee.types.Types.*;

/**
 * The second version (the paper, Fig. 5): making room ends. The robot backs for as long as a
 * timer runs, stands off the line until the front is clear and then returns.
 *
 * Every run of it is a run of Fig. 3, as far as Fig. 3 can see.
 */
component AvoidCrash refines coffee.fig3.AvoidCrash {
    port in Distance frontUS, in TimerSignal timerSig, out MotorCmd cmd, out TimerCmd timerCmd;

    <<completion = "chaos">> automaton {
        state driving, backing, waiting, remote, returning;

        initial driving / {cmd = fwd};

        driving -> backing {frontUS == tooClose} / {cmd = backRight, timerCmd = delay};
        driving -> waiting {frontUS == tooClose} / {cmd = stop};
        waiting -> driving {frontUS == clear} / {cmd = fwd};
        backing -> remote {timerSig == alert} / {cmd = stop};
        remote -> returning {frontUS == clear} / {cmd = fwd};
    }
}
