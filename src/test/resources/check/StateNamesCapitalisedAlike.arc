//// BadGuard.arc
component BadGuard {
  port in Boolean tooClose, out Boolean drive;

  automaton {
    state driving, waiting, Turning;
//                          ~~~~~~~ warning ARC0211: state 'Turning' starts with an upper case letter, unlike the other states; call it 'turning' or rename the others
    initial driving / {drive = true};

    driving -> waiting {tooClose == true} / {drive = false};
    waiting -> Turning {tooClose == true} / {drive = false};
    Turning -> driving {tooClose == false} / {drive = true};
  }
}

//// GoodGuard.arc
component GoodGuard {
  port in Boolean tooClose, out Boolean drive;

  automaton {
    state driving, waiting, turning;
    initial driving / {drive = true};

    driving -> waiting {tooClose == true} / {drive = false};
    waiting -> turning {tooClose == true} / {drive = false};
    turning -> driving {tooClose == false} / {drive = true};
  }
}
