package mill;

testsuite BeltsTest for mill.Belts(slow = true, easy = true) {
    test carryAtOnceOrLater {
        input {
            i: <6, Tk, 8, Tk, 10, Tk>;
        }
        expect {
            o: <5, Tk, 5, Tk, 5, Tk>;
            waiting: <0, Tk, 6, Tk, 8, Tk, 10, Tk>;
            late: <0, Tk, 6, Tk, 8, Tk, 10, Tk>;
        }
    }
}
