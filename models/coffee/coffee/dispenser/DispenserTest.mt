package coffee.dispenser;

testsuite DispenserTest for Dispenser {
    /** A fetcher gets one cup and leaves; the next one finds the magazine empty. */
    test servesUntilEmpty {
        input {
            ultrasonic.distance: <100, Tk, 10*(5, Tk), 100, Tk, 2*(5, Tk)>;
            magazine.pressed: <12*(true, Tk), 2*(false, Tk)>;
        }
        expect {
            slide.speed: <0, 2*Tk, 180, 4*Tk, -180, 4*Tk, 0, 4*Tk>;
        }
    }
}
