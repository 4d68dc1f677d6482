//// BadGuard.arc
component BadGuard {
  port in Boolean tooClose, out Boolean drive;

  automaton {
    state driving, waiting, driving;
//                          ~~~~~~~ error ARC0203: state 'driving' is declared twice; remove or rename one
    initial driving / {drive = true};

    driving -> waiting {tooClose == true} / {drive = false};
    waiting -> driving {tooClose == false} / {drive = true};
  }
}

//// GoodGuard.arc
component GoodGuard {
  port in Boolean tooClose, out Boolean drive;

  automaton {
    state driving, waiting;
    initial driving / {drive = true};

    driving -> waiting {tooClose == true} / {drive = false};
    waiting -> driving {tooClose == false} / {drive = true};
  }
}
