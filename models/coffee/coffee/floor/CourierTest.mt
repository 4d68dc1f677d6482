package coffee.floor;

testsuite CourierTest for Courier {
    /** Held below the spout, it stands, and goes on when it may. */
    test isHeld {
        input {
            ultrasonic.distance: <6*(100, Tk)>;
            left.value: <6*(20, Tk)>;
            right.value: <6*(20, Tk)>;
            cup.pressed: <6*(false, Tk)>;
            station.received: <2*Tk, hold, 2*Tk, go, 2*Tk>;
        }
        expect {
            leftMotor.speed: <2*(360, Tk), 0, 2*Tk, 2*(360, Tk)>;
            rightMotor.speed: <2*(360, Tk), 0, 2*Tk, 2*(360, Tk)>;
            display.text: <"driving", 6*Tk>;
        }
    }
}
