package yard;

import yard.Lights.*;

/** The second one is on at the moment at which the first one is: an output is what is asked for. */
component Answers {
    timing instant;

    port in Light first, out Light second;

    <<completion = "output">> automaton {
        state hearing;

        initial hearing;

        hearing {first == on} / {second = on};
    }
}
