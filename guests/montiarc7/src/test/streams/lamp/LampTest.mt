package lamp;

testsuite LampTest for Lamp {
    // Off is entered in the first slice. What is around is entered first, and begins with Red; Red is left for Free, which begins with Amber.
    test enteringBeginsInside {
        input {
            wish: <Tk, GO, Tk, Tk, GO, Tk, Tk, Tk>;
        }
        expect {
            colour: <DARK, Tk, RED, Tk, Tk, Tk, AMBER, Tk, Tk>;
            blink: <false, 4*Tk, true, Tk, true, Tk>;
            entered: <Tk, 10, Tk, 4*Tk>;
        }
    }

    // Green goes first, although Free around it has a transition for the same wish; what is done meanwhile is that of the state reached.
    test theInnermostComesFirst {
        input {
            wish: <GO, Tk, GO, Tk, Tk, STOP, Tk, OFF, Tk>;
        }
        expect {
            colour: <RED, Tk, Tk, AMBER, Tk, RED, Tk, DARK, Tk>;
            blink: <false, Tk, Tk, true, Tk, Tk, false, Tk>;
            left: <4*Tk, 201, Tk>;
        }
    }

    // Amber has a transition that is always taken, so Free's is not.
    test whatIsAroundIsHidden {
        input {
            wish: <GO, Tk, GO, Tk, STOP, Tk, Tk>;
        }
        expect {
            colour: <RED, Tk, Tk, AMBER, Tk, Tk>;
            blink: <false, Tk, Tk, true, Tk, true, Tk>;
        }
    }

    test leavingTellsFromInsideOut {
        input {
            wish: <GO, Tk, OFF, Tk, Tk>;
        }
        expect {
            colour: <RED, Tk, DARK, Tk, DARK, Tk>;
            left: <Tk, 101, Tk, Tk>;
        }
    }
}
