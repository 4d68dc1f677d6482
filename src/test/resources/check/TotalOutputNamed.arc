//// BadGuard.arc
component BadGuard {
  port in Boolean tooClose, <<total>> out Boolean drive;

  automaton {
    state driving, waiting;
    initial driving / {drive = true};

    driving -> waiting {tooClose == true};
//  ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ error ARC0327: no message is sent here on 'drive', which carries one in every slice (<<total>>); say which one
    waiting -> driving {tooClose == false} / {drive = true};
  }
}

//// GoodGuard.arc
component GoodGuard {
  port in Boolean tooClose, <<total>> out Boolean drive;

  automaton {
    state driving, waiting;
    initial driving / {drive = true};

    driving -> waiting {tooClose == true} / {drive = false};
    waiting -> driving {tooClose == false} / {drive = true};
  }
}

//// Silence.arc
component Silence {
  port in Boolean tooClose, <<total>> out Boolean drive, <<total>> out Integer speed;

  automaton {
    state driving;
    initial driving;
//  ~~~~~~~~~~~~~~~~ error ARC0327: no message is sent here on 'drive', 'speed', which carry one in every slice (<<total>>); say which one
    driving {tooClose == true} / {drive = --, speed = 0};
//                               ~~~~~~~~~~~~~~~~~~~~~~~ error ARC0327: no message is sent here on 'drive', which carries one in every slice (<<total>>); say which one
  }
}

//// BadTable.arc
component BadTable {
  port in Boolean tooClose, <<total>> out Boolean drive;

  table {
//~~~~~~~ error ARC0327: no message is sent here on 'drive', which carries one in every slice (<<total>>); say which one
    in tooClose;
    out drive;
    | true  | => | false |;
    | false | => | -- |;
//  ~~~~~~~~~~~~~~~~~~~~ error ARC0327: no message is sent here on 'drive', which carries one in every slice (<<total>>); say which one
  }
}

//// GoodTable.arc
component GoodTable {
  timing instant;
  port in Boolean tooClose, <<total>> out Boolean drive;

  table {
    in tooClose;
    out drive;
    | true  | => | false |;
    | false | => | true |;
    | --    | => | true |;
  }
}
