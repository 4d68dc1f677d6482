package mill;

/** Nobody says yet which pipes the horns have, but for one. */
component Alarm {
    feature leftHigh, leftLow, rightHigh;
    feature loud;
    port
        in Integer i,
        out Integer siren,
        out Integer rest,
        out Integer horn,
        out Integer second;
    constraint (loud implies leftHigh);
    component Siren(3, powerIsON = true, powerIsOFF = false) siren1;
    component Siren(tone = 4, powerIsON = false, powerIsOFF = true) siren2;
    component Horn(high = leftHigh, low = leftLow) left;
    component Horn(high = rightHigh, low = loud) right;
    constraint (leftLow || leftHigh);
    constraint (loud || rightHigh);
    connect i -> siren1.i, siren2.i, left.i, right.i;
    connect siren1.o -> siren;
    connect siren2.o -> rest;
    connect left.o -> horn;
    connect right.o -> second;
}
