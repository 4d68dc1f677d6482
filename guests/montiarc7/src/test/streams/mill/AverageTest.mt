package mill;

testsuite AverageTest for Average(4) {
    test isSequential {
        input {
            value: <8, Tk, Tk, 2, Tk>;
        }
        expect {
            mean: <6, Tk, Tk, 5, Tk>;
            last: <-1, Tk, 8, Tk, Tk, 8, Tk>;
        }
    }
}
