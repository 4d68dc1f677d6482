package mill;

testsuite GearsTest for mill.Gears {
    test areCalculated {
        expect {
            turns: <18, Tk>;
        }
    }
}
