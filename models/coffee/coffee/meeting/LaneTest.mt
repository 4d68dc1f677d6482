package coffee.meeting;

testsuite LaneTest for Lane {
    test showsWhatTheyCause {
        input {
            emptyCmd: <4*Tk, backRight, Tk, stop, 2*Tk, fwd, Tk>;
            loadedCmd: <6*Tk, fwd, 2*Tk>;
        }
        expect {
            emptyFront: <clear, 3*Tk, tooClose, 4*Tk, clear, 2*Tk>;
            loadedFront: <clear, 3*Tk, tooClose, 3*Tk, clear, 3*Tk>;
            emptyLine: <ok, 5*Tk, lost, 3*Tk, ok, Tk>;
            loadedLine: <ok, 9*Tk>;
        }
    }
}
