package coffee.floor;

testsuite BaristaTest for Barista {
    /** One cup is filled, and its fetcher may go. */
    test fillsACup {
        input {
            cup.pressed: <false, Tk, 13*(true, Tk)>;
            lamp.value: <3*(80, Tk), 9*(20, Tk), 2*(80, Tk)>;
        }
        expect {
            finger.speed: <0, 2*Tk, 180, 4*Tk, -180, 4*Tk, 0, 4*Tk>;
            fetcher.sent: <2*Tk, hold, 11*Tk, go, Tk>;
        }
    }
}
