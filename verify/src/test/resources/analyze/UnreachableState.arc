//// Bad.arc
component Bad {
  port in Boolean press, out Boolean light;

  <<completion = "ignore">> automaton {
    state off, on, lost, guarded;
//                 ~~~~ warning ARC1003: state lost is never reached: no transition leads to it
//                       ~~~~~~~ warning ARC1003: state guarded is never reached: no run carries out a transition that leads to it
    variable Integer[0..5] count = 0;
    initial off;
    off -> on [count == 5] {press == false} / {light = true};
//  ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC1004: transition off -> on can never be taken: no input enables it in any configuration that is reached
    off -> on {press == true} / {light = true, count = 1};
    on -> off [count < 5] {press == true} / {light = false, count = 2};
    on -> guarded [count > 2] {press == true} / {light = false};
//  ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC1004: transition on -> guarded can never be taken: no input enables it in any configuration that is reached
    guarded -> guarded {press == true} / {light = false};
//  ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC1004: transition guarded -> guarded can never be taken: its source guarded is never reached
    lost -> off {press == true} / {light = false};
//  ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC1004: transition lost -> off can never be taken: its source lost is never reached
  }
}

//// Good.arc
component Good {
  port in Boolean press, out Boolean light;

  <<completion = "ignore">> automaton {
    state off, on;
    initial off;
    off -> on {press == true} / {light = true};
    on -> off {press == true} / {light = false};
  }
}

//// BadWindow.arc
/** Without bounds: the last three readings are positive, which takes three steps to see. */
component BadWindow {
  port in Integer reading, out Integer first;

  <<completion = "ignore">> automaton {
    state running, broken;
//                 ~~~~~~ warning ARC1003: state broken is never reached: no run carries out a transition that leads to it
    variable Integer a = 1;
    variable Integer b = 1;
    variable Integer c = 1;
    initial running;
    running [reading > 0] / {a = b, b = c, c = reading, first = a};
    running -> broken [a <= 0] / {first = 0};
//  ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC1004: transition running -> broken can never be taken: no input enables it in any configuration that is reached
    broken {reading == ?} / {first = 1};
//  ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC1004: transition broken -> broken can never be taken: its source broken is never reached
  }
}

//// GoodWindow.arc
/** Without bounds: zero gets through, after three steps. */
component GoodWindow {
  port in Integer reading, out Integer first;

  <<completion = "ignore">> automaton {
    state running, broken;
    variable Integer a = 1;
    variable Integer b = 1;
    variable Integer c = 1;
    initial running;
    running [reading >= 0 && a > 0] / {a = b, b = c, c = reading, first = a};
    running -> broken [a <= 0] / {first = 0};
    broken {reading == ?} / {first = 1};
  }
}
