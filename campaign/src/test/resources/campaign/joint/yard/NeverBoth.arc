package yard;

import yard.Lights.*;

/** Two lamps are never on at the same time. */
component NeverBoth {
    timing instant;

    port in Light left, in Light right;

    <<completion = "error">> automaton {
        state none, one, other;

        initial none;

        none {left == --, right == --};
        none -> one {left == on, right == --};
        none -> other {left == --, right == on};

        one {left == --, right == --};
        one -> none {left == off, right == --};
        one -> other {left == off, right == on};

        other {left == --, right == --};
        other -> none {left == --, right == off};
        other -> one {left == on, right == off};
    }
}
