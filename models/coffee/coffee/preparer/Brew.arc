package coffee.preparer;

import coffee.types.Types.*;

/** Presses the button of a coffee machine once for each cup that is put below its spout. */
component Brew {
    port
        /** Whether a cup stands below the spout. */
        <<total>> in Boolean cup,
        /** Whether the machine's lamp says that it is hot and idle. */
        <<total>> in Boolean ready,
        in TimerSignal timerSig,
        out ArmCmd finger,
        out TimerCmd timerCmd;

    <<completion = "ignore">> automaton {
        state idle, pressing, releasing, brewing, done;

        initial idle / {finger = halt};

        idle -> pressing {cup == true, ready == true} / {finger = extend, timerCmd = delay};
        pressing -> releasing {timerSig == alert} / {finger = retract, timerCmd = delay};
        releasing -> brewing {timerSig == alert} / {finger = halt};
        // The lamp goes out when the button is pressed, and on again when the cup is full.
        brewing -> done {ready == true};
        done -> idle {cup == false};
    }
}
