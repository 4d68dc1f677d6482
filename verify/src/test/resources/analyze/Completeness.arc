//// BadChaos.arc
/** Silence is a matter of its own; here it is handled. */
component BadChaos {
  port in Boolean close, out Boolean drive;

  <<completion = "chaos">> automaton {
    state driving, waiting;
//        ~~~~~~~ warning ARC1002: in driving no transition handles {close = false}: anything may happen from then on (completion chaos)
//                 ~~~~~~~ warning ARC1002: in waiting no transition handles {close = true}: anything may happen from then on (completion chaos)
    initial driving / {drive = true};
    driving -> waiting {close == true} / {drive = false};
    driving {close == --} / {drive = true};
    waiting -> driving {close == false} / {drive = true};
    waiting {close == --} / {drive = false};
  }
}

//// BadSilence.arc
/** Only silence is missing. */
component BadSilence {
  port in Boolean close, out Boolean drive;

  <<completion = "output">> automaton {
    state only;
//        ~~~~ warning ARC1002: in only no transition handles silence: anything may be sent, and the state stays (completion output)
    initial only / {drive = true};
    only {close == true} / {drive = false};
    only {close == false} / {drive = true};
  }
}

//// BadGap.arc
/** The guards leave a gap, but not at first. */
component BadGap {
  port <<total>> in Integer distance, out Boolean drive;

  <<completion = "error">> automaton {
    state near, far;
//        ~~~~ error ARC1002: in near (limit = 20) no transition handles {distance = 20}: that is forbidden (completion error), but this input can come
    variable Integer[0..50] limit = 10;
    initial far / {drive = true};
    far -> near [distance < limit] / {drive = false, limit = 20};
    far [distance >= limit] / {drive = true};
    near [distance < limit] / {drive = false};
    near -> far [distance > limit] / {drive = true};
  }
}

//// BadEvent.arc
component BadEvent {
  timing untimed;
  port in Boolean press, in Integer[0..3] amount, <<state>> in Boolean open, out Boolean ring;

  <<completion = "output">> automaton {
    state idle;
//        ~~~~ warning ARC1002: in idle no transition handles {amount = 0}: anything may be sent, and the state stays (completion output)
    initial idle;
    idle [open == true] {press == ?} / {ring = true};
    idle [open == false] {press == ?} / {ring = false};
    idle [open == --] {press == ?};
  }
}

//// GoodIgnore.arc
/** Says itself that it is complete. */
component GoodIgnore {
  port in Boolean close, out Boolean drive;

  <<completion = "ignore">> automaton {
    state driving;
    initial driving / {drive = true};
    driving {close == true} / {drive = false};
  }
}

//// GoodTotal.arc
component GoodTotal {
  port <<total>> in Integer distance, out Boolean drive;

  <<completion = "error">> automaton {
    state only;
    initial only / {drive = true};
    only [distance < 10] / {drive = false};
    only [distance >= 10] / {drive = true};
  }
}

//// BadEnd.arc
/** In the second state nothing at all is handled. */
component BadEnd {
  port in Integer distance, out Boolean drive;

  automaton {
    state driving, ended;
//                 ~~~~~ warning ARC1002: in ended no transition handles {distance = 0}: anything may happen from then on (completion chaos)
//                 ~~~~~ warning ARC1005: from ended on nothing is sent any more: no transition that sends can be taken
//                 ~~~~~ warning ARC1006: one slice without a message, and nothing is promised any more: silence is not handled in ended (completion chaos)
    initial driving / {drive = true};
    driving {distance == ?} / {drive = true};
    driving -> ended {distance == --} / {drive = false};
  }
}

//// BadSum.arc
/** Without bounds: only behind 20 something is missing. */
component BadSum {
  port <<total>> in Integer more, out Integer told;

  <<completion = "output">> automaton {
    state low;
//        ~~~ warning ARC1002: in low (sum = 20) no transition handles {more = 1}: anything may be sent, and the state stays (completion output)
    variable Integer sum = 0;
    initial low;
    low [more > 0 && more < 8 && sum < 20] / {sum = sum + more};
    low [more <= 0 || sum < 20 && more >= 8] / {told = sum};
  }
}
