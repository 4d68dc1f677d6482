package mill;

import imported.Types.*;

testsuite TallyTest for Tally {
    // Of 5 both guards are true, and the first transition is taken.
    test theFirstInTheTextIsTaken {
        events {
            a: 2;
            a: 5;
            a: 12;
        }
        expect {
            sum: <-2, 5, 17>;
        }
    }

    test listsArePassedOn {
        events {
            list: ListOfString("x");
        }
        expect {
            copy: <ListOfString("x")>;
        }
    }
}
