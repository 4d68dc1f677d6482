package events;

import types.Signals.*;

/** Event-driven: one event a step, streams of messages, a latched value. */
component Counter {
  timing untimed;

  port
    in Key key,
    <<state>> in Boolean night,
    out Integer number,
    out Light light;

  <<completion = "ignore">> automaton {
    variable Integer total = 0;
    state counting, full;

    initial counting / {light = red};

    counting [total < 3] {key == up} / {total = total + 1, number = total};
    counting -> full [total >= 3] {key == up} / {number = [total, 0], light = [yellow, green]};
    counting [night] {key == down} / {number = [1, 2, 3]};
    full -> counting {key == alt {down, hold}} / {total = 0};
  }
}
