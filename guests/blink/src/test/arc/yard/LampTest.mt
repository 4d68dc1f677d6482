package yard;

testsuite LampTest for Lamp {
    test blinks {
        expect {
            lit: <true, Tk, true, Tk, false, Tk, true>;
        }
    }
}
