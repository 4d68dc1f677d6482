//// BadCounter.arc
component BadCounter {
  port in Boolean press, out Integer count;

  automaton {
    variable Integer pressed = 0;
    state counting;
    initial counting;
    counting {press == true} / {count = pressed, pressed++};
//                                               ~~~~~~~~~ error ARC0325: write 'pressed = pressed + 1' for 'pressed++'
  }
}

//// GoodCounter.arc
component GoodCounter {
  port in Boolean press, out Integer count;

  automaton {
    variable Integer pressed = 0;
    state counting;
    initial counting;
    counting {press == true} / {count = pressed, pressed = pressed + 1};
  }
}

//// Calls.arc
component Calls {
  port in Boolean press, out Integer count;

  automaton {
    state counting;
    initial counting;
    counting {press == true} / {count = 1, call beep()};
//                                         ~~~~~~~~~~~ error ARC0325: there are no calls in a block; send a message to a component that does what the call did
  }
}
