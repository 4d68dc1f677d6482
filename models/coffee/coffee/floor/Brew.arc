package coffee.floor;

import coffee.floor.Orders.*;
import coffee.types.Types.*;

/**
 * Fills cups as coffee.preparer.Brew does, and tells the fetcher to stand below the spout until its
 * cup is full.
 */
component Brew refines coffee.preparer.Brew {
    port
        <<total>> in Boolean cup,
        <<total>> in Boolean ready,
        in TimerSignal timerSig,
        out ArmCmd finger,
        out TimerCmd timerCmd,
        out Order order;

    <<completion = "ignore">> automaton {
        state idle, heating, pressing, releasing, brewing, done;

        initial idle / {finger = halt};

        idle -> pressing {cup == true, ready == true}
                / {finger = extend, timerCmd = delay, order = hold};
        // The fetcher has to wait for the machine.
        idle -> heating {cup == true, ready == false} / {order = hold};
        heating -> pressing {cup == true, ready == true} / {finger = extend, timerCmd = delay};
        heating -> idle {cup == false};

        pressing -> releasing {timerSig == alert} / {finger = retract, timerCmd = delay};
        releasing -> brewing {timerSig == alert} / {finger = halt};
        brewing -> done {ready == true} / {order = go};
        done -> idle {cup == false};
    }
}
