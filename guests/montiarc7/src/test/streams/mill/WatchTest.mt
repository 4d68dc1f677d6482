package mill;

testsuite WatchTest for mill.Watch {
    test isLoudAtTheThirdTime {
        input {
            speed: <10, Tk, 4, Tk, 11, Tk, 12, Tk, 13, Tk, 9, Tk>;
        }
        expect {
            alarm: <false, Tk, Tk, false, Tk, true, Tk, Tk, false, Tk>;
        }
    }
}
