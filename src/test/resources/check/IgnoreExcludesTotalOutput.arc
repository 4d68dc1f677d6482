//// BadGuard.arc
component BadGuard {
  port in Boolean tooClose, <<total>> out Boolean drive;

  <<completion = "ignore">> automaton {
//  ~~~~~~~~~~~~~~~~~~~~~ error ARC0328: 'ignore' sends nothing where no transition is enabled, but 'drive' carries a message in every slice; use "output" or "error"
    state driving;
    initial driving / {drive = true};
    driving {tooClose == true} / {drive = false};
  }
}

//// GoodGuard.arc
component GoodGuard {
  port in Boolean tooClose, <<total>> out Boolean drive;

  <<completion = "output">> automaton {
    state driving;
    initial driving / {drive = true};
    driving {tooClose == true} / {drive = false};
  }
}
