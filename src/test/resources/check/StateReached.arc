//// Bad.arc
component Bad {
  port in Boolean press, out Boolean light;

  automaton {
    state off, on, broken, mended;
//                 ~~~~~~ warning ARC1003: state broken is never reached: no run carries out a transition that leads to it
//                         ~~~~~~ warning ARC1003: state mended is never reached: no run carries out a transition that leads to it
    initial off;
    off -> on {press == true};
    on -> off {press == true};
    broken -> mended {press == true};
    mended -> broken;
  }
}

//// Alone.arc
component Alone {
  port in Boolean press;

  automaton {
    state off, on;
//             ~~ warning ARC1003: state on is never reached: no transition leads to it
    initial off;
    on;
  }
}

//// Meant.arc
component Meant {
  port in Boolean press;

  <<suppress = "ARC1003: a state to come">> automaton {
    state off, on;
    initial off;
  }
}

//// Good.arc
component Good {
  port in Boolean press, out Boolean light;

  <<suppress = "ARC1003: what guards do, only the analysis knows">> automaton {
    state off, on, broken;
    initial off;
    off -> on {press == true};
    on -> broken [press == true && press == false];
  }
}

//// Timer.arc
component Timer(Integer[1..3] slices) {
  port in Boolean press;

  automaton {
    state off, on;
    initial off;
  }
}
