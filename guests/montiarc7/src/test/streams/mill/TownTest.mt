package mill;

testsuite TownTest for mill.Town(alarmLeftHigh = true, alarmLeftLow = true, alarmRightHigh = false) {
    test hasTwoPipes {
        input {
            i: <5, Tk, 6, Tk>;
        }
        expect {
            horn: <10, Tk, 12, Tk>;
            siren: <8, Tk, 9, Tk>;
            rest: <0, Tk, 0, Tk>;
        }
    }
}
