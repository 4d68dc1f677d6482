package coffee.preparer;

testsuite PreparerTest for Preparer {
    /** One cup is filled and taken away; the next one starts the machine again. */
    test fillsTwoCups {
        input {
            cup.pressed: <false, Tk, 13*(true, Tk), false, Tk, 2*(true, Tk)>;
            lamp.value: <3*(80, Tk), 9*(20, Tk), 5*(80, Tk)>;
        }
        expect {
            finger.speed: <0, 2*Tk, 180, 4*Tk, -180, 4*Tk, 0, 6*Tk, 180, Tk>;
        }
    }
}
