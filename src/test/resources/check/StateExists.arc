//// BadGuard.arc
component BadGuard {
  port in Boolean tooClose, out Boolean drive;

  automaton {
    state driving, waiting;
    initial driving / {drive = true};

    driving -> waitng {tooClose == true} / {drive = false};
//             ~~~~~~ error ARC0304: there is no state 'waitng'; did you mean 'waiting'?
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

//// UsedThrice.arc
component UsedThrice {
  port in Boolean tooClose, out Boolean drive;

  automaton {
    state driving;
    initial elsewhere / {drive = true};
//          ~~~~~~~~~ error ARC0304: there is no state 'elsewhere'; declare it with 'state elsewhere;'

    driving -> elsewhere {tooClose == true} / {drive = false};
    elsewhere {tooClose == false} / {drive = true};
  }
}
