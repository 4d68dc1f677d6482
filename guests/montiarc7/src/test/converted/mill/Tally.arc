package mill;

import imported.Types.ListOfString;

/** Sums up what is large; lists are passed on, whatever is in them. */
component Tally {
    timing untimed;
    port in Integer a, in ListOfString list;
    port out Integer sum, out ListOfString copy;
    Integer total = 0;
    <<completion = "ignore">> automaton {
        state Counting;
        initial Counting;
        Counting -> Counting [a > 3] {a == ?} / do {
            total += a;
            sum = total;
        };
        Counting -> Counting [a < 10 && !(a > 3)] {a == ?} / do {
            sum = -a;
        };
        Counting -> Counting {list == ?} / do {
            copy = list;
        };
    }
}
