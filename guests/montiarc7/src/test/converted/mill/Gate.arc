/* A licence. */
package mill;

import mill.Signals.Switch;

/** Opens and closes. */
component Gate(Integer most = 3) {
    timing instant;
    port in Switch press, in Boolean blocked;
    port out Boolean open, <<delay = "1">> out Integer count;
    Integer opened = 0;
    <<completion = "ignore">> automaton {
        state Shut, Wide, Narrow;
        initial Shut / do {
            count = 0;
        };
        Shut -> Wide [press == Switch.ON && opened < most] / do {
            open = true;
        };
        Shut -> Shut [press == Switch.ON && !(opened < most)] / do {
            Integer left = most - opened;
            if (left < 0) {
                count = left;
            } else {
                count = opened;
            }
        };
        Wide -> Narrow [press == Switch.ON && opened > 1] / do {
            count = opened;
        };
        Wide -> Shut [(blocked || press == Switch.OFF)
                && ((press == -- || press != Switch.ON) || !(opened > 1))] / do {
            opened++;
            opened += 1;
            count = opened;
        };
        Narrow -> Shut [blocked || press == Switch.OFF] / do {
            opened++;
            opened += 1;
            count = opened;
        };
    }
}
