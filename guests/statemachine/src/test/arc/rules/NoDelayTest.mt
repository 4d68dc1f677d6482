package rules;

testsuite NoDelayTest for NoDelay {
    test theFirstStepEnters {
        input { event: <Tk, next, Tk>; }
        expect { entered: <1, Tk, 2, Tk>; }
    }
}
