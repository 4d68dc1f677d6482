package coffee.dispenser;

import coffee.types.Types.*;

/** Drops one cup for each fetcher that stops below, as long as there are cups. */
component DropCup {
    port
        /** tooClose: a fetcher stands below the chute. */
        in Distance below,
        /** Whether there is a cup left in the magazine. */
        <<total>> in Boolean cups,
        in TimerSignal timerSig,
        out ArmCmd slide,
        out TimerCmd timerCmd;

    <<completion = "ignore">> automaton {
        state ready, pushing, pulling, served;

        initial ready / {slide = halt};

        ready -> pushing {below == tooClose, cups == true} / {slide = extend, timerCmd = delay};
        pushing -> pulling {timerSig == alert} / {slide = retract, timerCmd = delay};
        pulling -> served {timerSig == alert} / {slide = halt};
        // One cup each: the next one only after this fetcher has left.
        served -> ready {below == clear};
    }
}
