package rules;

import rules.Rules.*;

/** Says what a history does before there is one: it begins, with all that beginnings do. */
component NotYet {
    port
        in Event event,
        out Integer began,
        out Integer beganWithin,
        out Integer entered;

    <<completion = "ignore">> statemachine {
        initial outside;

        state outside;

        state outer {
            initial inner / {began = 1};

            state inner {
                initial first / {beganWithin = 1};

                state first { entry / {entered = 1}; }
                state second { entry / {entered = 2}; }

                first -> second {event == next};
            }

            inner -> inner.history {event == again};
        }

        outside -> outer.history {event == resume};
        outside -> outer.deepHistory {event == jump};
        outside -> inner.history {event == within};
        outer -> outside {event == leave};
    }
}
