package single;

import types.Signals.*;

/** Delay 0, echo of inputs, output completion. */
component Instant {
  timing instant;

  port
    in Key key,
    in Integer number,
    out Key echo,
    out Integer doubled,
    out Boolean large;

  <<completion = "output">> automaton {
    state only;
    initial only;

    only [number > 3] / {echo = key, doubled = number * 2, large = true};
    only [number <= 3] / {doubled = number + number, large = number == 3};
  }
}
