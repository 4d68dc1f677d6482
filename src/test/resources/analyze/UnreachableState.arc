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
