//// BadShare.arc
component BadShare {
  port in Integer[0..4] total, in Integer[0..4] parts, out Integer share;

  <<completion = "ignore">> automaton {
    state only;
    initial only;
    only {total == ?} / {share = total / parts};
//  ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ error ARC1008: run error in only on {total = 0, parts = 0}: division by zero
  }
}

//// BadGuard.arc
component BadGuard {
  port in Boolean press, out Boolean light;

  <<completion = "ignore">> automaton {
    state only;
    variable Integer[-2..2] speed = 2;
    initial only;
    only [10 % speed == 0] {press == true} / {speed = speed - 1, light = true};
//  ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ error ARC1008: run error in only (speed = 0) on {press = true}: division by zero
  }
}

//// GoodShare.arc
component GoodShare {
  port in Integer[0..4] total, in Integer[0..4] parts, out Integer share;

  <<completion = "ignore">> automaton {
    state only;
    initial only;
    only [parts != 0] {total == ?} / {share = total / parts};
  }
}

//// BadSum.arc
/** Without bounds. */
component BadSum {
  port in Integer more, out Integer share;

  <<completion = "ignore">> automaton {
    state adding;
    variable Integer total = 0;
    initial adding;
    adding [more > 0 && more <= 40 && total <= 100] / {total = total + more};
    adding {more == 0} / {share = 600 / (total - 137)};
//  ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ error ARC1008: run error in adding (total = 137) on {more = 0}: division by zero
  }
}

//// GoodSum.arc
component GoodSum {
  port in Integer more, out Integer share;

  <<completion = "ignore">> automaton {
    state adding;
    variable Integer total = 0;
    initial adding;
    adding [more > 0 && more <= 40 && total <= 100] / {total = total + more};
    adding {more == 0} / {share = 600 / (total - 141)};
  }
}
