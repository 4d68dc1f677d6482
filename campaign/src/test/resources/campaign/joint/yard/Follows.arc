package yard;

import yard.Lights.*;

/** Once the first one is on, the second one is so after as many moments: no sooner, no later. */
component Follows(Integer least, Integer most) {
    timing instant;

    port in Light first, in Light second;

    <<completion = "error">> automaton {
        state before, waiting, after;

        variable Integer moments = 0;

        initial before;

        before {first == --, second == --};
        before -> waiting {first == on, second == --} / {moments = 1};

        waiting [moments < most] {second == --} / {moments = moments + 1};
        waiting -> after [moments >= least] {second == on};

        after -> after;
    }
}
