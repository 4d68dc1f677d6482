//// BadGuard.arc
component BadGuard {
  port in Boolean tooClose, out Boolean drive;

  automaton {
    state driving;
    initial driving / {drive = true};
    driving {toClose == true} / {drive = false};
//           ~~~~~~~ error ARC0305: there is no input port or variable 'toClose'; did you mean 'tooClose'?
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
