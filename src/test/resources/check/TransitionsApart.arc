// profile: executable
//// Bad.arc
component Bad {
  port in Boolean tooClose, in Integer[0..9] speed, out Boolean drive;

  <<completion = "ignore">> automaton {
    state driving, waiting, resting;
    initial driving;
    driving -> waiting {tooClose == true} / {drive = false};
//  ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC1001: two transitions out of driving are enabled together: 'arcomat analyze' shows a run
    driving {tooClose == ?} / {drive = true};
    driving {tooClose == --};
    waiting {speed == alt {1, 2}} / {drive = true};
//  ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC1001: two transitions out of waiting are enabled together: 'arcomat analyze' shows a run
//  ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC1001: two transitions out of waiting are enabled together: 'arcomat analyze' shows a run
    waiting {speed == 2};
    waiting -> resting {tooClose == true, speed == 1};
    waiting {speed == 3, tooClose == false} / {drive = tooClose};
  }
}

//// Good.arc
component Good {
  port in Boolean tooClose, in Integer[0..9] speed, in Double far, out Boolean drive;

  <<completion = "error">> automaton {
    state driving, waiting, never;
    variable Integer[0..9] count = 0;
    initial driving;
    driving -> waiting {tooClose == true} / {drive = false};
    driving {tooClose == false} / {drive = true};
    driving {tooClose == --} / {count = count + 1};
    waiting {speed == 1} / {drive = tooClose};
    waiting {speed == 1, tooClose == --};
    waiting [speed == 2];
    waiting [speed == 2];
//  ~~~~~~~~~~~~~~~~~~~~~ warning ARC0349: this transition is written above already; correct one of them, or delete this one
    waiting {count == 3};
    waiting {far == 1.0};
    waiting {far == 1.0};
//  ~~~~~~~~~~~~~~~~~~~~~ warning ARC0349: this transition is written above already; correct one of them, or delete this one
    waiting -> never {speed == 4} / {count = count + 9};
    never {speed == 5};
    never {speed == 5};
//  ~~~~~~~~~~~~~~~~~~~ warning ARC0349: this transition is written above already; correct one of them, or delete this one
  }
}

//// Open.arc
component Open {
  port in Boolean tooClose, out Boolean drive;

  automaton {
    state driving;
    initial driving;
    driving {tooClose == true} / {drive = false};
    driving {tooClose == true} / {drive = true};
  }
}

//// Events.arc
component Events {
  timing untimed;
  port in Boolean tooClose, out Boolean drive;

  <<completion = "ignore">> automaton {
    state driving;
    initial driving;
    driving {tooClose == true} / {drive = false};
    driving {tooClose == true} / {drive = true};
  }
}
