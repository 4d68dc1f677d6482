package awkward;

import awkward.Words.*;

/** Driven by events whose names generated code would like for itself. */
component Queue {
  timing untimed;

  port
    in int start,
    in Object react,
    in boolean handle,
    in int place,
    <<state>> in int queued,
    in Object waiting,
    in Object section0,
    out int border,
    out Object sendBorder,
    out boolean message;

  <<completion = "ignore">> automaton {
    variable int oldest, waitingStart, sentBorder0 = 1;
    state Border, taken;

    initial Border / {border = oldest};

    Border -> taken {start == ?} / {oldest = start, border = [start, queued, sentBorder0]};
    Border {place == ?} / {waitingStart = place, sentBorder0 = waitingStart};
    Border {react == ?} / {sendBorder = [react, Public]};
    taken -> Border {handle == ?} / {message = handle};
    taken {waiting == int_} / {sendBorder = waiting};
    taken {section0 == ?} / {sendBorder = section0, border = waitingStart};
  }
}
