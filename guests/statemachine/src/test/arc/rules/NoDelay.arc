package rules;

import rules.Rules.*;

/** Begins in a state that sends nothing when it is entered; the first step enters the one that does. */
component NoDelay {
    timing instant;
    port in Event event, out Integer entered;

    <<completion = "ignore">> statemachine {
        initial start;

        state start;
        state first { entry / {entered = 1}; }
        state second { entry / {entered = 2}; }

        start -> first;
        first -> second {event == next};
    }
}
