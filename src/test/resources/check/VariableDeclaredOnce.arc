//// BadCounter.arc
component BadCounter {
  port in Boolean press, out Integer count;

  automaton {
    variable Integer pressed = 0;
    variable Long pressed = 0;
//                ~~~~~~~ error ARC0212: variable 'pressed' is declared twice; remove or rename one
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
    counting {press == true} / {pressed = pressed + 1, count = pressed};
  }
}
