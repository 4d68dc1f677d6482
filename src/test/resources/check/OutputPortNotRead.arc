//// BadCounter.arc
component BadCounter {
  port in Boolean press, out Integer count;

  automaton {
    state counting;
    initial counting / {count = 0};
    counting {press == true} / {count = count + 1};
//                                      ~~~~~ error ARC0308: output port 'count' cannot be read; keep what was sent in a variable
  }
}

//// GoodCounter.arc
component GoodCounter {
  port in Boolean press, out Integer count;

  automaton {
    variable Integer pressed = 0;
    state counting;
    initial counting / {count = 0};
    counting {press == true} / {pressed = pressed + 1, count = pressed + 1};
  }
}

//// InGuard.arc
component InGuard {
  port in Boolean press, out Integer count;

  automaton {
    state counting;
    initial counting / {count = 0};
    counting [count > 3] {press == true} / {count = 0};
//            ~~~~~ error ARC0308: output port 'count' cannot be read; keep what was sent in a variable
  }
}
