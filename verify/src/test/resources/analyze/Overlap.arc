//// BadChoice.arc
/** Both transitions answer, and it is seen which one. */
component BadChoice {
  port in Boolean close, out Integer[0..9] speed;

  <<completion = "ignore">> automaton {
    state driving, waiting;
    initial driving / {speed = 9};
    driving -> driving {close == true} / {speed = 1};
//  ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC1001: in driving on {close = true} two transitions are enabled, and what is sent differs: {speed = 1} or {speed = 0}
    driving -> waiting {close == true} / {speed = 0};
    waiting -> driving {close == false} / {speed = 9};
  }
}

//// BadMemory.arc
/** What is sent is the same, but not what is remembered. */
component BadMemory {
  port in Boolean close, out Boolean stop;

  <<completion = "ignore">> automaton {
    state driving, waiting;
    variable Integer[0..3] count = 0;
    initial driving / {count = 1};
    driving -> waiting {close == true} / {stop = true};
//  ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC1001: in driving (count = 1) on {close = true} two transitions are enabled, and send the same, but lead to different configurations: waiting (count = 1) or waiting (count = 0)
    driving -> waiting [count > 0] {close == true} / {stop = true, count = 0};
    waiting -> driving {close == false} / {stop = false};
  }
}

//// BadTwin.arc
/** The second transition adds nothing; they meet only after the third press. */
component BadTwin {
  port in Boolean press, out Boolean light;

  <<completion = "ignore">> automaton {
    state off;
    variable Integer[0..3] count = 0;
    initial off;
    off [count < 3] {press == true} / {count = count + 1};
//  ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC1001: in off (count = 2) on {press = true} two transitions are enabled, and what is sent differs: nothing or {light = true}
    off [count >= 2] {press == true} / {light = true, count = 3};
//  ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC1001: in off (count = 3) on {press = true} two transitions are enabled, with the same effect: one of them is enough
    off [count == 3] {press == ?} / {light = true};
  }
}

//// BadLate.arc
/** In the one case that both want, one of them divides by zero. */
component BadLate {
  port in Integer[0..2] a, out Integer share;

  <<completion = "ignore">> automaton {
    state only;
    initial only;
    only [a < 2] / {share = 4 / a};
//  ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC1001: in only on {a = 0} two transitions are enabled, and what is sent differs: a run error or {share = 0}
//  ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ error ARC1008: run error in only on {a = 0}: division by zero
    only [a == 0] / {share = 0};
  }
}

//// GoodChoice.arc
component GoodChoice {
  port in Boolean close, in Integer gap, out Integer[0..9] speed;

  <<completion = "ignore">> automaton {
    state driving;
    variable Integer[0..100] least = 10;
    initial driving / {speed = 9};
    driving [gap <= least] {close == true} / {speed = 0};
    driving [gap > least] {close == true} / {speed = 1, least = 20};
    driving {close == true, gap == --} / {speed = 2};
  }
}

//// BadSum.arc
/** Without bounds: found by the solver. */
component BadSum {
  port in Integer more, out Integer told;

  <<completion = "ignore">> automaton {
    state low, high;
    variable Integer sum = 0;
    initial low;
    low [more > 0 && more < 8 && sum < 100] / {sum = sum + more, told = more};
    low [sum > 20] {more == 0} / {told = 1};
//  ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC1001: in low (sum = 21) on {more = 0} two transitions are enabled, and send the same, but lead to different configurations: low (sum = 21) or high (sum = 21)
    low -> high [sum > 20] {more == 0} / {told = 1};
    high [more > sum] / {told = 2};
//  ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC1001: in high (sum = 21) on {more = 22} two transitions are enabled, with the same effect: one of them is enough
//  ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC1001: in high (sum = 21) on {more = 43} two transitions are enabled, and what is sent differs: {told = 2} or {told = 3}
    high [more >= sum] / {told = 2};
//  ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC1001: in high (sum = 21) on {more = 43} two transitions are enabled, and what is sent differs: {told = 2} or {told = 3}
    high -> low [more > 2 * sum] / {told = 3, sum = 0};
  }
}

//// GoodSum.arc
/** Without bounds: proved by the solver. */
component GoodSum {
  port in Integer more, out Integer told;

  <<completion = "ignore">> automaton {
    state low;
    variable Integer sum = 0;
    initial low;
    low [more > sum] / {sum = more, told = more};
    low [more < sum] / {told = sum};
    low [more == sum] / {told = 0};
  }
}
