//// Bad.arc
component Bad {
  port in Boolean press, in Integer[0..9] level, out Boolean light;

  <<completion = "ignore">> automaton {
    state off, on;
    variable Integer[0..3] count = 0;
    initial off;
    off -> on {press == true} / {light = true};
    on -> off [count == 0] {press == true} / {light = false};
    on -> off [count > 0] {press == false} / {light = false};
//  ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC1004: transition on -> off can never be taken: no input enables it in any configuration that is reached
    on [level > 4 && level < 5] / {light = true};
//  ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC1004: transition on -> on can never be taken: no input enables it in any configuration that is reached
  }
}

//// BadTable.arc
/** The second row is the first one again. */
component BadTable {
  timing instant;
  port in Boolean press, out Boolean light;

  <<completion = "ignore">> table {
    in press;
    out light;
    | true | => | true |;
    | true | => | false |;
//  ~~~~~~~~~~~~~~~~~~~~~~ warning ARC1004: transition table -> table can never be taken: no input enables it in any configuration that is reached
  }
}

//// Good.arc
component Good {
  port in Boolean press, in Integer[0..9] level, out Boolean light;

  <<completion = "ignore">> automaton {
    state off, on;
    variable Integer[0..3] count = 0;
    initial off;
    off -> on {press == true} / {light = true, count = 2};
    on -> off [count > 0] {press == false} / {light = false};
    on [level > 3 && level < 5] {press == --} / {light = true};
  }
}

//// BadSum.arc
/** Without bounds: at most 140. */
component BadSum {
  port in Integer more, out Integer told;

  <<completion = "ignore">> automaton {
    state adding;
//        ~~~~~~ warning ARC1005: from adding (sum = 101) on nothing is sent any more: no transition that sends can be taken
    variable Integer sum = 0;
    initial adding;
    adding [more > 0 && more <= 40 && sum <= 100] / {sum = sum + more, told = sum};
    adding [sum == 140] {more == 0} / {sum = 0, told = 0};
    adding [sum > 140] {more == 0} / {sum = 0, told = 0};
//  ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC1004: transition adding -> adding can never be taken: no input enables it in any configuration that is reached
  }
}

//// BadLatched.arc
/** A latched port never loses its message. */
component BadLatched {
  timing untimed;
  port <<state>> in Boolean open, in Boolean tick, in Boolean tock, out Boolean light;

  <<completion = "ignore">> automaton {
    state early, late;
    initial early;
    early -> late {tick == ?, open == true} / {light = true};
    late -> early {tock == ?, open == false} / {light = false};
    late {tick == ?, open == --} / {light = true};
//  ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC1004: transition late -> late can never be taken: no input enables it in any configuration that is reached
  }
}

//// GoodLatched.arc
/** As long as it has none it stays without; and whatever event there was, the next may be another. */
component GoodLatched {
  timing untimed;
  port <<state>> in Boolean open, in Boolean tick, in Boolean tock, out Boolean light;

  <<completion = "ignore">> automaton {
    state early, later, late;
    initial early;
    early -> later {tick == ?, open == --} / {light = true};
    later -> late {tock == ?, open == --} / {light = false};
    late -> early {tick == ?, open == --} / {light = true};
    late {tock == ?, open == true} / {light = true};
  }
}
