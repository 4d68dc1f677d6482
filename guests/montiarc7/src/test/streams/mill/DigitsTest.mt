package mill;

testsuite DigitsTest for Digits {
    test areSummedUp {
        input {
            number: <1234, Tk, 905, Tk, 7, Tk>;
        }
        expect {
            sum: <10, Tk, 14, Tk, 7, Tk>;
            even: <true, Tk, true, Tk, Tk>;
        }
    }
}
