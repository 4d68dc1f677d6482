package coffee.parts;

testsuite ProximityTest for Proximity(25, 35) {
    test hysteresis {
        input {
            distance: <80, Tk, 30, Tk, 25, Tk, 26, Tk, 34, Tk, 35, Tk, 255, Tk, 0, Tk>;
        }
        expect {
            front: <clear, 2*Tk, tooClose, 3*Tk, clear, Tk, clear, Tk, tooClose, Tk>;
        }
    }
}
