//// BadCounter.arc
component BadCounter {
  port in Boolean press, out Integer count;

  automaton {
    variable Integer pressed = false;
//                             ~~~~~ error ARC0317: variable 'pressed' takes Integer, but 'false' is of type Boolean
    state counting;
    initial counting;
    counting {press == true} / {count = pressed};
  }
}

//// GoodCounter.arc
component GoodCounter {
  port in Boolean press, out Integer count;

  automaton {
    variable Integer pressed = 0;
    state counting;
    initial counting;
    counting {press == true} / {count = pressed};
  }
}
