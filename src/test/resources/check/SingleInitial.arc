// profile: executable
//// BadLamp.arc
component BadLamp {
  port in Boolean press, out Boolean light;

  automaton {
    state off, on;
    initial off / {light = false};
    initial on / {light = true};
//          ~~ error ARC0303: generated code starts in one state, and 'off' is initial already; decide for one of the two

    off -> on {press == true} / {light = true};
    on -> off {press == true} / {light = false};
  }
}

//// GoodLamp.arc
component GoodLamp {
  port in Boolean press, out Boolean light;

  automaton {
    state off, on;
    initial off / {light = false};

    off -> on {press == true} / {light = true};
    on -> off {press == true} / {light = false};
  }
}
