package coffee.fetcher;

testsuite CupHolderTest for CupHolder {
    test ignoresBumps {
        input {
            pressed: <false, Tk, true, Tk, false, Tk, 3*(true, Tk), false, Tk, true, Tk,
                    2*(false, Tk)>;
        }
        expect {
            gotCoffee: <5*(false, Tk), 5*(true, Tk), false, Tk>;
        }
    }
}
