//// BadCounter.arc
component BadCounter {
  port in Boolean press, out Integer count;

  automaton {
    variable Integer pressed = 0;
    state counting;
    initial counting;
    counting {press == true} / {pressed = [1, 2], count = pressed};
//                                        ~~~~~~ error ARC0312: variable 'pressed' holds one value, not a list; write one value
  }
}

//// GoodCounter.arc
component GoodCounter {
  port in Boolean press, out Integer count;

  automaton {
    variable Integer pressed = 0;
    state counting;
    initial counting;
    counting {press == true} / {pressed = pressed + 1, count = pressed};
  }
}
