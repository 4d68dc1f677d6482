package mill;

testsuite ChainTest for Chain(10) {
    test argumentsGoByName {
        input {
            input: <5, Tk, Tk, 6, Tk>;
        }
        expect {
            output: <17, Tk, Tk, 18, Tk>;
        }
    }
}
