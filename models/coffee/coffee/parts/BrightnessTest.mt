package coffee.parts;

testsuite BrightnessTest for Brightness(60) {
    test limit {
        input {
            value: <80, Tk, 60, Tk, 59, Tk, -5, Tk>;
        }
        expect {
            bright: <true, Tk, true, Tk, false, Tk, false, Tk>;
        }
    }
}
