package single;

import types.Signals.*;

/** One output at once, the other a slice later. */
component Mixed(Integer limit, Light colour = Light.yellow) {
  Integer twice = limit * 2;

  port
    in Integer[0..9] level,
    <<delay = "0">> out Boolean alarm,
    out Light light;

  <<completion = "ignore">> automaton {
    state low, high;

    initial low / {light = colour};

    low [level < limit] / {alarm = false};
    low -> high [level >= limit && level < twice] / {alarm = true, light = green};
    low -> high [level >= twice] / {alarm = true, light = red};
    high -> low [level < limit] / {alarm = false, light = colour};
  }
}
