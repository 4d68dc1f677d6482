package wrong;

/** The tool's own findings point at what was written. */
component Own {
    port in Boolean go, out Integer x;

    statemachine {
        initial one;
        state one { entry / {y = 1}; }
        state two { exit / {x = true}; }
        one -> two [goo];
        two -> one {go == 3};
    }
}
