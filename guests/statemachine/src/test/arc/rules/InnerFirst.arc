package rules;

import rules.Rules.*;

/** Who comes first, and what is done where nobody comes. */
component InnerFirst {
    port
        in Event event,
        in Boolean go,
        out Integer took,
        out Boolean within,
        out Integer around;

    <<completion = "ignore">> statemachine {
        priority inner;

        initial outer;

        state outer {
            do / {around = 1};

            initial first;

            state first { do / {within = true}; }
            state second;

            first -> second {event == next} / {took = 2};
            outer {go == true} / {took = 1};
        }
    }
}
