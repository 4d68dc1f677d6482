package coffee.fetcher;

/** The scenario of Fig. 1, from the sensors to the wheels of either fetcher. */
testsuite FetcherTest for Fetcher {
    /**
     * Without coffee: it backs off the line to the right, lets the other one pass, drives on until
     * a light sensor sees the line, and steers back onto it.
     */
    test makesRoomAndReturnsToTheLine {
        input {
            ultrasonic.distance: <100, Tk, 5*(20, Tk), 5*(100, Tk)>;
            left.value: <3*(20, Tk), 6*(70, Tk), 2*(20, Tk)>;
            right.value: <3*(20, Tk), 7*(70, Tk), 20, Tk>;
            cup.pressed: <11*(false, Tk)>;
        }
        expect {
            leftMotor.speed: <2*(360, Tk), -360, 3*Tk, 0, 2*Tk, 360, Tk, 360, Tk, 120, Tk, 360, Tk>;
            rightMotor.speed: <2*(360, Tk), -120, 3*Tk, 0, 2*Tk, 4*(360, Tk)>;
        }
    }

    /** With coffee: it stops, stands while the other one is near, and goes on. */
    test waitsWithCoffee {
        input {
            ultrasonic.distance: <2*(100, Tk), 2*(20, Tk), 30, Tk, 3*(100, Tk)>;
            left.value: <8*(20, Tk)>;
            right.value: <8*(20, Tk)>;
            cup.pressed: <8*(true, Tk)>;
        }
        expect {
            leftMotor.speed: <3*(360, Tk), 0, 3*Tk, 2*(360, Tk)>;
            rightMotor.speed: <3*(360, Tk), 0, 3*Tk, 2*(360, Tk)>;
        }
    }
}
