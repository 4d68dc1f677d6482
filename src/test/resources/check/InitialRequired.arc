//// BadGuard.arc
component BadGuard {
  port in Boolean tooClose, out Boolean drive;

  automaton Stop {
//          ~~~~ error ARC0302: automaton 'Stop' has no initial state; say where it starts, for example with 'initial driving;'
    state driving, waiting;

    driving -> waiting {tooClose == true} / {drive = false};
    waiting -> driving {tooClose == false} / {drive = true};
  }
}

//// GoodGuard.arc
component GoodGuard {
  port in Boolean tooClose, out Boolean drive;

  automaton Stop {
    state driving, waiting;
    initial driving / {drive = true};

    driving -> waiting {tooClose == true} / {drive = false};
    waiting -> driving {tooClose == false} / {drive = true};
  }
}
