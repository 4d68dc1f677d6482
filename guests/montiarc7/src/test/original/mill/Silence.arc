package mill;

/** The order of the text decides, and what is silent is neither true nor false. */
component Silence {
  port sync in int x, sync in boolean quiet;
  port sync out int out;

  automaton {
    initial state S;

    S -> S [x == null && quiet == null] / { out = 0; };
    S -> S [x == null || quiet && x > 5] / { out = 1; };
    S -> S [x > 2] / { out = 2; };
    S -> S [!quiet] / { out = 3; };
    S -> S / { out = 4; };
    S -> S [x == 7] / { out = 5; };
  }
}
