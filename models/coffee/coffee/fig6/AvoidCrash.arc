package coffee.fig6;

import coffee.types.Types.*;

/**
 * The third version (the paper, Fig. 6), and the one that runs: coffee decides who makes room,
 * and the robot is back in service once it sees the line again.
 *
 * gotCoffee is total: it carries a message in every slice. Were it allowed to be absent, neither
 * transition of driving would be enabled on {frontUS = tooClose} without it, the robot would send
 * nothing, and the promise of Fig. 5 (and of Fig. 3) to react would be broken. The shortest
 * counterexample is that one letter: {tooClose}/{}.
 *
 * What the earlier versions left open is closed here: on every other input the robot carries on.
 */
component AvoidCrash refines coffee.fig5.AvoidCrash {
    port
        in Distance frontUS,
        in TimerSignal timerSig,
        in LineStatus ls,
        <<total>> in Boolean gotCoffee,
        out MotorCmd cmd,
        out TimerCmd timerCmd;

    <<completion = "ignore">> automaton {
        state driving, backing, waiting, remote, returning;

        initial driving / {cmd = fwd};

        // Who has no coffee makes room; who has some waits, lest it be spilt.
        driving -> backing {frontUS == tooClose, gotCoffee == false}
                / {cmd = backRight, timerCmd = delay};
        driving -> waiting {frontUS == tooClose, gotCoffee == true} / {cmd = stop};
        waiting -> driving {frontUS == clear} / {cmd = fwd};

        backing -> remote {timerSig == alert} / {cmd = stop};
        remote -> returning {frontUS == clear} / {cmd = fwd};
        returning -> driving {ls == ok};
    }
}
