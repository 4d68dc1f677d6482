//// BadSink.arc
/** Two traps; one has two states. */
component BadSink {
  port in Boolean press, in Boolean stop, out Boolean light;

  <<completion = "ignore">> automaton {
    state off, ended, idling, resting;
//             ~~~~~ warning ARC1005: from ended on nothing is sent any more: no transition that sends can be taken
//                    ~~~~~~ warning ARC1005: from idling on nothing is sent any more: no transition that sends can be taken; the trap is {idling, resting}
    initial off / {light = false};
    off {press == true} / {light = true};
    off -> idling {press == false};
    idling -> resting {press == true} / {light = --};
    resting -> idling {press == false};
    off -> ended {press == --, stop == true} / {light = false};
  }
}

//// BadCounter.arc
/** After three presses the lamp is dark for ever. */
component BadCounter {
  port in Boolean press, out Boolean light;

  <<completion = "ignore">> automaton {
    state only;
//        ~~~~ warning ARC1005: from only (left = 0) on nothing is sent any more: no transition that sends can be taken
    variable Integer[0..3] left = 3;
    initial only;
    only [left > 0] {press == true} / {light = true, left = left - 1};
  }
}

//// BadDumb.arc
component BadDumb {
  port in Boolean press, out Boolean light;

  <<completion = "ignore">> automaton {
    state only;
//        ~~~~ warning ARC1005: from only on nothing is sent any more: no transition that sends can be taken
    initial only / {light = true};
    only {press == true};
  }
}

//// GoodLamp.arc
component GoodLamp {
  port in Boolean press, out Boolean light;

  <<completion = "ignore">> automaton {
    state off, silent;
    initial off / {light = false};
    off -> silent {press == true};
    silent -> off {press == true} / {light = true};
  }
}

//// GoodSink.arc
/** Has nothing to send. */
component GoodSink {
  port in Boolean press;

  <<completion = "ignore">> automaton {
    state only;
    initial only;
    only {press == true};
  }
}

//// GoodFree.arc
/** What is omitted may be anything. */
component GoodFree {
  port in Boolean press, out Boolean light;

  <<completion = "ignore", omitted = "free">> automaton {
    state only;
    initial only;
    only {press == true};
  }
}

//// GoodEvents.arc
/** Whatever happened before, a push is answered. */
component GoodEvents {
  timing untimed;
  port in Integer push, <<state>> in Boolean quiet, out Integer sum;

  <<completion = "ignore">> automaton {
    state only;
    variable Integer total = 0;
    initial only;
    only [total < 1000 && push > 0 && push < 1000] {push == ?} / {total = total + push, sum = total};
    only [push < 0] {push == ?} / {sum = 0};
    only [quiet == false && push == 0] {push == ?};
  }
}

//// BadChoice.arc
/** Of two ways into a trap that are as short the first is told. */
component BadChoice {
  port in Boolean left, out Boolean light;

  <<completion = "ignore">> automaton {
    state start, one, two;
//               ~~~ warning ARC1005: from one on nothing is sent any more: no transition that sends can be taken; the trap is {one, two}
    initial start;
    start {left == --} / {light = true};
    start -> two {left == true};
    start -> one {left == false};
    one -> two {left == ?};
    two -> one {left == ?};
  }
}

//// BadRunsOut.arc
/** The same without a range: what is left may also fall below zero. */
component BadRunsOut {
  port in Integer more, out Integer told;

  <<completion = "ignore">> automaton {
    state only;
//        ~~~~ warning ARC1005: from only (left = 0) on nothing is sent any more: no transition that sends can be taken
    variable Integer left = 30;
    initial only;
    only [left > 0 && more > 0 && more < 9] / {left = left - more, told = more};
    only [left <= 0 && more > 0 && more < 9] / {left = left - left};
  }
}

//// BadBest.arc
/** Nothing is better than the greatest number. */
component BadBest {
  port in Integer level, out Integer told;

  <<completion = "ignore">> automaton {
    state only;
//        ~~~~ warning ARC1005: from only (best = 2147483647) on nothing is sent any more: no transition that sends can be taken
    variable Integer best = 0;
    initial only;
    only [level > best] / {best = level, told = level};
  }
}

//// GoodBest.arc
/** It is as good as itself. */
component GoodBest {
  port in Integer level, out Integer told;

  <<completion = "ignore">> automaton {
    state only;
    variable Integer best = 0;
    initial only;
    only [level >= best] / {best = level, told = level};
  }
}

//// BadLatched.arc
/** Once it has been held, nothing is sent. */
component BadLatched {
  timing untimed;
  port <<state>> in Boolean held, in Integer more, out Integer told;

  <<completion = "ignore">> automaton {
    state only;
//        ~~~~ warning ARC1005: from only (sum = 1) on nothing is sent any more: no transition that sends can be taken
    variable Integer sum = 0;
    initial only;
    only [sum < 900 && more > 0 && more < 9 && held == --] / {sum = sum + more, told = sum};
    only [sum >= 900 && held == --] {more == 0} / {sum = 0, told = 0};
    only [sum < 901 && more > 0 && more < 9 && held] / {sum = sum + 1};
  }
}
