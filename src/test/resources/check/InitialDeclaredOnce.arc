//// BadLamp.arc
component BadLamp {
  port in Boolean press, out Boolean light;

  automaton {
    state off, on;
    initial off / {light = false};
    initial off / {light = true};
//          ~~~ error ARC0204: state 'off' is declared initial twice; keep the declaration with the output that is meant

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
    initial on / {light = true};

    off -> on {press == true} / {light = true};
    on -> off {press == true} / {light = false};
  }
}

//// TwiceInOneClause.arc
component TwiceInOneClause {
  port in Boolean press, out Boolean light;

  automaton {
    state off;
    initial off, off / {light = false};
//               ~~~ error ARC0204: state 'off' is declared initial twice; keep the declaration with the output that is meant
    off {press == true};
  }
}
