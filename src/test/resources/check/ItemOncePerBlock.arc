//// BadGuard.arc
component BadGuard {
  port in Boolean tooClose, out Boolean drive;

  automaton {
    state driving;
    initial driving / {drive = true};
    driving {tooClose == true} / {drive = false, drive = true};
//                                               ~~~~~ error ARC0310: this block names output port 'drive' twice; keep one of the two
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

//// OmittedName.arc
component OmittedName {
  port in Boolean tooClose, out Boolean drive;

  automaton {
    state driving;
    initial driving / {drive = true};
    driving {tooClose == true, false} / {drive = false};
//                             ~~~~~ error ARC0310: this block names input port 'tooClose' twice, here by the type of the message; keep one of the two
  }
}
