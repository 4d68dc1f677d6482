package ${packageName};

/**
 * What goes in, slice by slice, and what has to come out. Tk ends a slice, a tenth of a second on the
 * robot.
 *
 * Try: a test of your own. What does the pilot do at 61 cm, when it is turning?
 */
testsuite ${component}PilotTest for ${component}Pilot {
    test turnsWhereSomethingIsNear {
        input {
            distance: <255, Tk, 31, Tk, 30, Tk>;
        }
        expect {
            move: <forward, Tk, forward, Tk, turn, Tk>;
        }
    }

    test goesOnWhereTheWayIsClear {
        input {
            distance: <20, Tk, 60, Tk, 61, Tk>;
        }
        expect {
            move: <turn, Tk, turn, Tk, forward, Tk>;
        }
    }
}
