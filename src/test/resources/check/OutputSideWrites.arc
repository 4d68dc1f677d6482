//// BadGuard.arc
component BadGuard {
  port in Boolean tooClose, out Boolean drive;

  automaton {
    state driving;
    initial driving / {drive = true};
    driving {tooClose == true} / {tooClose = false};
//                                ~~~~~~~~ error ARC0307: nothing can be written to input port 'tooClose': it only receives; name an output port or a variable
  }
}

//// GoodGuard.arc
component GoodGuard {
  port in Boolean tooClose, out Boolean drive;

  automaton {
    state driving;
    initial driving / {drive = true};
    driving {tooClose == true} / {drive = false};
  }
}

//// Delay.arc
component Delay(Integer slices) {
  port in Boolean press, out Boolean light;

  automaton {
    state waiting;
    initial waiting;
    waiting {press == true} / {light = true, slices = 4};
//                                           ~~~~~~ error ARC0307: nothing can be written to parameter 'slices': it keeps its value; declare a 'variable' in the automaton for what changes
  }
}
