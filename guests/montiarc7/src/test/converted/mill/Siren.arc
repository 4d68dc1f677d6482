package mill;

/** Loud at once, or not at all. */
component Siren(Integer tone) {
    feature powerIsOFF, powerIsON;
    constraint ((powerIsON || powerIsOFF) && !(powerIsON && powerIsOFF));
    timing instant;
    port in Integer i, out Integer o;
    varif (powerIsON) {
        <<completion = "ignore">> compute {
            o = i + tone;
        }
    }
    varif (powerIsOFF) {
        <<completion = "ignore">> compute {
            o = 0;
        }
    }
}
