package p;

/** Counts bumps, and says when there were three. */
component Counter {
    timing untimed;

    port in Boolean pressed, out Boolean enough;

    <<completion = "ignore">> automaton {
        state counting;

        variable Integer[0..3] bumps = 0;

        initial counting / {enough = false};

        counting [bumps < 2] {pressed == true} / {bumps = bumps + 1};
        counting [bumps == 2] {pressed == true} / {bumps = 3, enough = true};
    }
}
