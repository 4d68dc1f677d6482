package coffee.fetcher;

testsuite LineStatusCompTest for LineStatusComp(45) {
    test seesTheLine {
        input {
            leftLight: <20, Tk, 60, Tk, 20, Tk, 45, Tk>;
            rightLight: <20, Tk, 20, Tk, 60, Tk, 45, Tk>;
        }
        expect {
            ls: <3*(ok, Tk), lost, Tk>;
            drift: <none, Tk, left, Tk, right, Tk, none, Tk>;
        }
    }
}
