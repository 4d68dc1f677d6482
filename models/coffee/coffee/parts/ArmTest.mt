package coffee.parts;

testsuite ArmTest for Arm {
    test moves {
        input {
            cmd: <halt, Tk, extend, 2*Tk, retract, Tk, halt, Tk>;
        }
        expect {
            speed: <0, Tk, 180, 2*Tk, -180, Tk, 0, Tk>;
        }
    }
}
