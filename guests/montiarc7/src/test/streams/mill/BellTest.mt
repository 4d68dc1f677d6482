package mill;

testsuite BellTest for Bell {
    // The initial action first, and then what is done on entering; afterwards each question.
    test strikesInOrder {
        events {
            ask: 1;
            ask: 2;
            ask: 3;
            ask: 4;
        }
        expect {
            strike: <(0, -1, 0), (0, 1, 3, 5), (8, 10, 11, 11), (6, 14, 32, 5), (11, 11, 21, 21, 5)>;
        }
    }

    test waysSendMoreOrLess {
        events {
            ask: 5;
            ask: 0;
            ask: 9;
            ask: -1;
            ask: -2;
            ask: -3;
        }
        expect {
            strike: <(0, -1, 0), (6, 5, 5), (0, 1, 2, 4, 4), (1, 10, 2, 9, 5), (-1, 11, 5), (-2, 5), (-3, 12, 5)>;
            late: <false, true, true>;
        }
    }
}
