//// Bad.arc
component Bad {
  port in Boolean close, out Boolean drive;

  automaton {
    state waiting, driving, dark;
//                 ~~~~~~~ warning ARC1006: one slice without a message, and nothing is promised any more: silence is not handled in waiting, driving (completion chaos)
    initial driving / {drive = true};
    driving -> waiting {close == true} / {drive = false};
    driving -> dark {close == false} / {drive = true};
    dark {close == ?} / {drive = true};
    dark {close == --} / {drive = true};
    waiting {close == ?} / {drive = false};
  }
}

//// GoodKept.arc
component GoodKept {
  port in Boolean close, out Boolean drive;

  automaton {
    state driving;
    initial driving / {drive = true};
    driving {close == ?} / {drive = false};
    driving {close == --} / {drive = true};
  }
}

//// GoodTotal.arc
/** Is never silent. */
component GoodTotal {
  port <<total>> in Boolean close, out Boolean drive;

  automaton {
    state driving;
    initial driving / {drive = true};
    driving {close == true} / {drive = false};
    driving {close == false} / {drive = true};
  }
}

//// GoodOutput.arc
/** Keeps its state, and so its promises; completeness has something to say. */
component GoodOutput {
  port in Boolean close, out Boolean drive;

  <<completion = "output">> automaton {
    state driving;
//        ~~~~~~~ warning ARC1002: in driving no transition handles {close = false}: anything may be sent, and the state stays (completion output)
    initial driving / {drive = true};
    driving {close == true} / {drive = false};
  }
}

//// BadSum.arc
/** Without bounds: silence is handled up to 50. */
component BadSum {
  port in Integer more, out Integer sum;

  automaton {
    state adding;
//        ~~~~~~ warning ARC1006: one slice without a message, and nothing is promised any more: silence is not handled in adding (completion chaos)
    variable Integer total = 0;
    initial adding;
    adding [total <= 50] {more == --} / {sum = total};
    adding [more > 0 && more <= 20 && total <= 100] / {total = total + more};
    adding [more <= 0 || more > 20 || total > 100] {more == ?} / {sum = total};
  }
}
