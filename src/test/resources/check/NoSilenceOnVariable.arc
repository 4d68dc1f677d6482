//// BadGuard.arc
component BadGuard {
  port in Boolean tooClose, out Boolean drive;

  automaton {
    variable Boolean moving = true;
    state driving;
    initial driving / {drive = true};
    driving {tooClose == true} / {drive = false, moving = --};
//                                                        ~~ error ARC0313: '--' is about messages, but variable 'moving' always has a value; write a value or drop the item
  }
}

//// GoodGuard.arc
component GoodGuard {
  port in Boolean tooClose, out Boolean drive;

  automaton {
    variable Boolean moving = true;
    state driving;
    initial driving / {drive = true};
    driving {tooClose == true} / {drive = false, moving = false};
  }
}

//// AnyMessage.arc
component AnyMessage {
  port in Boolean tooClose, out Boolean drive;

  automaton {
    variable Boolean moving = true;
    state driving;
    initial driving / {drive = true};
    driving {tooClose == true, moving == ?} / {drive = false, moving = false};
//                                       ~ error ARC0313: '?' is about messages, but variable 'moving' always has a value; write a value or drop the item
  }
}
