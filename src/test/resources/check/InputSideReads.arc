//// BadGuard.arc
component BadGuard {
  port in Boolean tooClose, out Boolean drive;

  automaton {
    state driving;
    initial driving / {drive = true};
    driving {tooClose == true, drive == true} / {drive = false};
//                             ~~~~~ error ARC0306: the input side cannot ask for output port 'drive'; keep what was sent in a variable or in the state
  }
}

//// GoodGuard.arc
component GoodGuard {
  port in Boolean tooClose, out Boolean drive;

  automaton {
    variable Boolean moving = true;
    state driving;
    initial driving / {drive = true};
    driving {tooClose == true, moving == true} / {drive = false, moving = false};
  }
}

//// Delay.arc
component Delay(Integer slices) {
  port in Boolean press, out Boolean light;

  automaton {
    state waiting;
    initial waiting;
    waiting {slices == 3, press == true} / {light = true};
//           ~~~~~~ error ARC0306: the input side cannot ask for parameter 'slices'; ask for its value in a guard, as in '[slices == ..]'
  }
}
