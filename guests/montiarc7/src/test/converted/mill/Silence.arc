package mill;

/** The order of the text decides, and what is silent is neither true nor false. */
component Silence {
    timing instant;
    port in Integer x, in Boolean quiet;
    port out Integer out;
    <<completion = "ignore">> automaton {
        state S;
        initial S;
        S -> S [x == -- && quiet == --] / do {
            out = 0;
        };
        S -> S [(x == -- || quiet && x > 5) && (x != -- || quiet != --)] / do {
            out = 1;
        };
        S -> S [x > 2 && (x != -- && ((quiet == -- || !quiet) || !(x > 5)))] / do {
            out = 2;
        };
        S -> S [!quiet && (x != -- && (!quiet || (x == -- || !(x > 5)))) && (x == -- || !(x > 2))]
                / do {
            out = 3;
        };
        S -> S [(x != -- || quiet != --)
                && (x != -- && ((quiet == -- || !quiet) || (x == -- || !(x > 5))))
                && (x == -- || !(x > 2)) && (quiet == -- || quiet)] / do {
            out = 4;
        };
    }
}
