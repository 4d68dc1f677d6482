package single;

import types.Signals.*;

/** What is not handled is an error that ends the run; a total port speaks in every slice. */
component Forbidden {
  port
    <<total>> in Key key,
    in Boolean open,
    <<total>> out Light light;

  <<completion = "error">> automaton {
    state closed, opened;

    initial closed / {light = red};

    closed -> opened {key == up} / {light = green};
    closed {key == alt {down, hold}} / {light = red};
    opened -> closed {key == down} / {light = yellow};
    opened {open == ?, key == hold} / {light = green};
    opened {open == --, key == hold} / {light = red};
    opened [key == up] / {light = green};
  }
}
