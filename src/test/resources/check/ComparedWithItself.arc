//// BadLamp.arc
component BadLamp {
  port in Boolean tick, in Integer level, out Boolean light;

  automaton {
    state off, on;
    initial off;
    off -> on {tick} / {light = true};
//             ~~~~ warning ARC0337: this compares 'tick' with itself, so every message fits; write 'tick == true', or 'tick == ?' if any message is meant
    on -> off {!tick} / {light = false};
//             ~~~~~ warning ARC0337: this compares 'tick' with its own negation, so no message fits; write 'tick == false'
    on {level == level} / {light = true};
//      ~~~~~~~~~~~~~~ warning ARC0337: this compares 'level' with itself, so every message fits; write 'level == ?' if any message is meant
  }
}

//// GoodLamp.arc
component GoodLamp {
  port in Boolean tick, in Integer level, out Boolean light;

  automaton {
    state off, on;
    initial off;
    off -> on {tick == true} / {light = tick};
    on -> off {tick == false, level == ?} / {light = false};
    on [tick] {level == 3} / {light = true};
  }
}
