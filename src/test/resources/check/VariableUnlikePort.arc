//// BadCounter.arc
component BadCounter {
  port in Boolean press, out Integer count;

  automaton {
    variable Integer count = 0;
//                   ~~~~~ error ARC0205: variable 'count' is named like output port 'count'; rename the variable
    state counting;
    initial counting;
    counting {press == true} / {count = 1};
  }
}

//// GoodCounter.arc
component GoodCounter {
  port in Boolean press, out Integer count;

  automaton {
    variable Integer pressed = 0;
    state counting;
    initial counting;
    counting {press == true} / {pressed = pressed + 1, count = pressed + 1};
  }
}

//// Delay.arc
component Delay(Integer slices) {
  port in Boolean press, out Boolean light;

  automaton {
    variable Integer slices = 0;
//                   ~~~~~~ error ARC0205: variable 'slices' is named like parameter 'slices'; rename the variable
    state waiting;
    initial waiting;
    waiting {press == true} / {light = true};
  }
}

//// NoEcho.arc
component NoEcho {
  port in Boolean press, <<total>> out Boolean light;

  automaton {
    variable Integer light = 0;
//                   ~~~~~ error ARC0205
    state waiting;
    initial waiting / {light = true};
    waiting {press == true} / {light = true};
  }
}
