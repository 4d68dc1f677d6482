package wrong;

/** At the start a port without delay has no message. */
component NoDelay {
    timing instant;
    port in Boolean go, out Integer x;

    statemachine {
        initial around;

        state around {
            entry / {x = 1};
            initial one;
            state one;
        }

        state other;

        around -> other {go == true};
        other -> around {go == true};
    }
}
