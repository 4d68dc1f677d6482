package rules;

import rules.Rules.*;

/** Says what is left and entered: the answers that are known, in KnownTest. */
component Known {
    port
        in Event event,
        out Boolean enteredOuter,
        out Boolean leftOuter,
        out Integer entered,
        out Integer left,
        out Integer sum;

    <<completion = "ignore">> statemachine {
        variable Integer[0..9] count = 0;

        initial outside;

        state outside;

        state outer {
            entry / {enteredOuter = true, count = 1};
            exit / {leftOuter = true};

            initial first / {count = 2};

            state first { entry / {entered = 1}; exit / {left = 1}; }
            state second { entry / {entered = 2, count = 3}; exit / {left = 2}; }

            first -> second {event == next};
            outer {event == within} / {sum = count};
            outer -> outer {event == again};
            outer -> second {event == jump};
            second -> outer {event == up};
        }

        outside -> outer {event == enter};
        outside -> outer.history {event == resume};
        outer -> outside {event == leave} / {sum = count};
    }
}
