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

//// BadRange.arc
/** A message beyond the range of its port helps nobody out. */
component BadRange {
  port in Integer[0..3] level, in Integer more, out Integer told;

  <<completion = "ignore">> automaton {
    state only;
    variable Integer best = 0;
    variable Integer sum = 0;
    initial only;
    only [level > best] / {best = level, told = level};
    only [more > 0 && more < 9 && sum < 900] {level == --} / {sum = sum + more};
  }
}

//// GoodParity.arc
/** What arithmetic forbids leads into no trap. */
component GoodParity {
  port in Integer p, out Integer told;

  <<completion = "ignore">> automaton {
    state only, sink;
    variable Integer sum = 0;
    initial only;
    only [sum < 100 && p > 0 && p < 9] / {sum = sum + 2 * p};
    only [sum >= 100] {p == 0} / {sum = 0, told = 0};
    only -> sink [sum % 2 == 1] {p == 3};
  }
}

//// GoodWraps.arc
/** The greatest number and one more is less. */
component GoodWraps {
  port in Integer p, out Integer told;

  <<completion = "ignore">> automaton {
    state only;
    variable Integer last = 0;
    initial only;
    only [p + 1 < p && last != 5] / {last = p, told = last};
    only [p > 0 && p < 9] / {last = p};
  }
}

//// BadNaN.arc
/** What is no number stays none, and infinity becomes none. */
component BadNaN {
  port in Double level, in Boolean ask, out Double told;

  <<completion = "ignore">> automaton {
    state only;
    variable Double sum = 0.0;
    initial only;
    only {level == ?, ask == --} / {sum = sum + level};
    only [sum < 100.0] {ask == true} / {told = sum};
  }
}

//// BadWord.arc
component BadWord {
  port in String word, out String told;

  <<completion = "ignore">> automaton {
    state reading, checking;
    variable String last = "go";
    initial reading;
    reading -> checking {word == ?} / {last = word};
    checking -> reading [last == "go"] {word == ?} / {told = word};
    checking -> checking [last == "no"] {word == "no"};
  }
}

//// GoodWord.arc
component GoodWord {
  port in String word, out String told;

  <<completion = "ignore">> automaton {
    state reading, checking;
    variable String last = "go";
    initial reading;
    reading -> checking {word == ?} / {last = word};
    checking -> reading [last == word] / {told = word};
  }
}

//// GoodSilence.arc
/** Only silence is answered, and not always. */
component GoodSilence {
  port in Integer p, out Integer told;

  <<completion = "ignore">> automaton {
    state only;
    variable Integer sum = 0;
    initial only;
    only [p > 0 && p < 9 && sum < 1000000] / {sum = sum + p};
    only [sum != 7] {p == --} / {sum = 0, told = sum};
  }
}

//// GoodWrong.arc
/** A run error is no trap: it is told elsewhere. */
component GoodWrong {
  port in Integer p, out Integer told;

  <<completion = "ignore">> automaton {
    state start, last;
    variable Integer n = 0;
    initial start;
    start -> last {p == ?} / {n = p, told = p};
    last [p > 0 && p < 9 && 1 / (n - p) == 2];
  }
}

//// GoodCircle.arc
/** A thousand steps, but each is one. */
component GoodCircle {
  port in Integer p, out Integer told;

  <<completion = "ignore">> automaton {
    state there, back;
    variable Integer n = 0;
    initial there;
    there -> back [n < 1000 && p > 0 && p < 4] / {n = n + p};
    back -> there [n < 2000 && p > 0 && p < 4] / {n = n + 1};
    there [n >= 1000] {p == 0} / {told = n, n = 0};
  }
}

//// BadCircle.arc
/** It goes round, and comes no closer to anything. */
component BadCircle {
  port in Integer p, out Integer told;

  <<completion = "ignore">> automaton {
    state there, back;
    variable Integer n = 0;
    initial there;
    there -> back [n < 1000 && p > 0 && p < 4] / {n = n + p};
    back -> there [p > 0 && p < 4] / {n = n - p};
    there [n >= 1000000] {p == 0} / {told = n, n = 0};
  }
}

//// BadSoon.arc
/** It is in the trap before it is in the state of the trap. */
component BadSoon {
  port in Integer p, out Integer told;

  <<completion = "ignore">> automaton {
    state first, second, third;
    variable Integer n = 0;
    initial first;
    first -> second {p == ?} / {n = p, told = p};
    second -> third {p == ?};
    third -> first [n > 5] {p == 3} / {told = n};
  }
}

//// GoodNever.arc
/** Nobody gets to where nothing is sent: it would take more than it adds. */
component GoodNever {
  port in Integer p, out Integer told;

  <<completion = "ignore">> automaton {
    state only, sink;
    variable Integer n = 0;
    initial only;
    only [n < 100 && p > 0 && p < 9] / {n = n + p, told = n};
    only [n >= 100] {p == 0} / {n = 0, told = 0};
    only -> sink [n > 107] {p == 1};
  }
}

//// BadLatched.arc
/** Once it has been held, nothing is sent. */
component BadLatched {
  timing untimed;
  port <<state>> in Boolean held, in Integer more, out Integer told;

  <<completion = "ignore">> automaton {
    state only;
    variable Integer sum = 0;
    initial only;
    only [sum < 900 && more > 0 && more < 9 && held == --] / {sum = sum + more, told = sum};
    only [sum >= 900 && held == --] {more == 0} / {sum = 0, told = 0};
    only [sum < 900 && more > 0 && more < 9 && held] / {sum = sum + 1};
  }
}
