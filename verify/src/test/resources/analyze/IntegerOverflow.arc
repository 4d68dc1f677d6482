//// BadSum.arc
component BadSum {
  port in Integer more, out Integer sum;

  <<completion = "ignore">> automaton {
    state adding;
    variable Integer total = 0;
    initial adding;
    adding [more > 0] / {total = total + more, sum = total};
//  ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC1009: in adding (total = 2) on {more = 2147483647} an integer overflows and wraps around; give ports and variables ranges
  }
}

//// BadGuard.arc
component BadGuard {
  port in Integer a, in Integer b, out Boolean less;

  <<completion = "ignore">> automaton {
    state only;
    initial only;
    only [a - b < 0] / {less = true};
//  ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC1009: in only on {a = 2147483647, b = -2147483648} an integer overflows and wraps around; give ports and variables ranges
    only [a - b >= 0] / {less = false};
//  ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC1009: in only on {a = 2147483647, b = -2147483648} an integer overflows and wraps around; give ports and variables ranges
  }
}

//// BadNegation.arc
component BadNegation {
  port in Integer a, out Integer size;

  <<completion = "ignore">> automaton {
    state only;
    initial only;
    only {a == ?} / {size = a < 0 ? -a : a};
//  ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC1009: in only on {a = -2147483648} an integer overflows and wraps around; give ports and variables ranges
  }
}

//// GoodSum.arc
component GoodSum {
  port in Integer more, out Integer sum;

  <<completion = "ignore">> automaton {
    state adding;
    variable Integer total = 0;
    initial adding;
    adding [more > 0 && more < 1000 && total < 1000000] / {total = total + more, sum = total};
  }
}

//// GoodCounter.arc
/** Reaches 20000 at most, one by one. */
component GoodCounter {
  port in Boolean press, out Integer count;

  <<completion = "ignore">> automaton {
    state counting;
    variable Integer presses = 0;
    initial counting;
    counting [presses < 20000] {press == true} / {presses = presses + 1, count = presses};
    counting [presses == 20000] {press == true} / {presses = 0, count = presses};
  }
}

//// BadQuotient.arc
/** There is one quotient that does not fit. */
component BadQuotient {
  port in Integer whole, in Integer[-1..3] parts, out Integer share;

  <<completion = "ignore">> automaton {
    state only;
    initial only;
    only [parts != 0] {whole == ?} / {share = whole / parts};
//  ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC1009: in only on {whole = -2147483648, parts = -1} an integer overflows and wraps around; give ports and variables ranges
  }
}

//// GoodCountdown.arc
/** Proved with what nobody asks: the counter never falls below zero. */
component GoodCountdown {
  port in Integer[0..9] start, in Boolean tick, out Integer left, out Integer share;

  <<completion = "ignore">> automaton {
    state counting;
    variable Integer count = 0;
    initial counting;
    counting [count < 100] {start == ?} / {count = count + start, left = count};
    counting [count > 0] {tick == true, start == --} / {count = count - 1, left = count};
    counting {tick == false, start == --} / {share = 1000 / (count + 1), left = count % (count + 1)};
  }
}

//// BadFirst.arc
/** The level that is held to begin with is the highest one. */
component BadFirst {
  timing untimed;
  port <<state = "2147483647">> in Integer[2147483640..2147483647] level, in Boolean tick, out Integer next;

  <<completion = "ignore">> automaton {
    state only;
    initial only;
    only {tick == ?} / {next = level + 1};
//  ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC1009: in only on {tick = false} an integer overflows and wraps around; give ports and variables ranges
  }
}
