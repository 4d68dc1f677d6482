//// BadCounter.arc
component BadCounter {
  port in Boolean press, out Integer count;

  <<completion = "ignore">> automaton {
    state counting;
    variable Integer[0..3] presses = 0;
    initial counting;
    counting {press == true} / {presses = presses + 1, count = presses};
//  ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ error ARC1007: run error in counting (presses = 3) on {press = true}: presses = 4 is outside Integer[0..3]
    counting {press == false} / {presses = 0, count = 0};
  }
}

//// BadPort.arc
component BadPort {
  port in Integer[0..20] wanted, out Integer[0..9] speed;

  <<completion = "ignore">> automaton {
    state only;
    initial only;
    only {wanted == ?} / {speed = wanted / 2};
//  ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ error ARC1007: run error in only on {wanted = 20}: speed = 10 is outside Integer[0..9]
  }
}

//// BadStart.arc
component BadStart(Integer most = 12) {
  port in Boolean press, out Boolean light;

  <<completion = "ignore">> automaton {
    state only;
    variable Integer[0..9] left = most;
    initial only;
//  ~~~~~~~~~~~~~ error ARC1007: run error at the start: BadStart, value of left (line 6): left = 12 is outside Integer[0..9]
    only {press == true} / {light = true};
  }
}

//// GoodCounter.arc
component GoodCounter {
  port in Boolean press, out Integer[0..3] count;

  <<completion = "ignore">> automaton {
    state counting;
    variable Integer[0..3] presses = 0;
    initial counting;
    counting {press == true} / {presses = (presses + 1) % 4, count = presses};
  }
}

//// BadSum.arc
/** Without bounds but for what is sent. */
component BadSum {
  port in Integer more, out Integer[0..110] sum;

  <<completion = "ignore">> automaton {
    state adding;
    variable Integer total = 0;
    initial adding;
    adding [more > 0 && more <= 40 && total <= 100] / {total = total + more};
    adding {more == 0} / {sum = total};
//  ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ error ARC1007: run error in adding (total = 111) on {more = 0}: sum = 111 is outside Integer[0..110]
  }
}

//// GoodSum.arc
component GoodSum {
  port in Integer more, out Integer[0..140] sum;

  <<completion = "ignore">> automaton {
    state adding;
    variable Integer total = 0;
    initial adding;
    adding [more > 0 && more <= 40 && total <= 100] / {total = total + more};
    adding {more == 0} / {sum = total};
  }
}

//// GoodShare.arc
/** By a number that is not known before: what divides is smaller than what is divided. */
component GoodShare {
  port in Integer[0..100000] whole, in Integer[0..100000] parts, out Integer[0..100000] share,
       out Integer[0..99999] rest;

  <<completion = "ignore">> automaton {
    state only;
    initial only;
    only [parts > 0] {whole == ?} / {share = whole / parts, rest = whole % parts};
  }
}
