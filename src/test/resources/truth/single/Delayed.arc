package single;

import types.Signals.*;

/** Delay 1, alternatives on the input side, silence, presence, overlaps, chaos where nothing fits. */
component Delayed {
  port
    in Key key,
    in Boolean night,
    out Light light,
    out Integer count;

  automaton {
    variable Integer steps = 3, unused;
    state off, on, blinking;

    initial off / {light = red, steps = 1};

    off -> on {key == alt {up, hold}} / {light = green, count = steps, steps = steps + 1};
    off -> blinking {key == ?, night == true} / {yellow};
    off {key == --} / {count = steps};
    on -> off {key == down} / {light = red};
    on -> blinking [night] / {light = yellow, count = -steps};
    on -> off [!night && steps > 4] / {steps = 0};
    blinking -> off [key == -- || night implies key == up] / {light = --};
    blinking -> on [night <=> (key isin {up, down})] / {count = if night then 1 else steps * 2};
  }
}
