package coffee.parts;

import coffee.types.Types.*;

/**
 * Answers delay with alert, a number of slices later. A delay while it runs starts it anew.
 *
 * slices: from the slice that carries delay to the one that carries alert; at least 2
 */
component Timer(Integer[2..3000] slices) {
    port in TimerCmd timerCmd, out TimerSignal timerSig;

    <<completion = "ignore">> automaton {
        state idle, running;

        /** Slices that are still to pass. */
        variable Integer[0..3000] left;

        initial idle;

        idle -> running {timerCmd == delay} / {left = slices - 1};
        running {timerCmd == delay} / {left = slices - 1};
        running [left > 1] {timerCmd == --} / {left = left - 1};
        running -> idle [left == 1] {timerCmd == --} / {timerSig = alert, left = 0};
    }
}
