package single;

import types.Signals.*;

/** An error is the completion, but the last transition of a state leaves nothing to complete. */
component Unrefusing {
  port
    in Key key,
    out Light light;

  <<completion = "error">> automaton {
    state one, two;

    initial one;

    one -> two {key == up} / {light = green};
    one / {light = red};
    two -> one / {light = yellow};
  }
}
