package coffee.parts;

import coffee.types.Types.*;

/** Turns what an arm is told into the speed of the one motor that moves it. */
component Arm {
    timing instant;

    port
        in ArmCmd cmd,
        /** In degrees per second. */
        out Integer speed;

    table {
        in cmd;
        out speed;
        | extend  | => | 180  |;
        | retract | => | -180 |;
        | halt    | => | 0    |;
        | --      | => | --   |;
    }
}
