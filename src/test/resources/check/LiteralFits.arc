//// BadLimit.arc
component BadLimit {
  port in Boolean i, out Long o;

  automaton {
    state running;
    initial running;
    running {i == true} / {o = 3000000000};
//                             ~~~~~~~~~~ error ARC0331: '3000000000' is too large for Integer; append L for a Long
  }
}

//// GoodLimit.arc
component GoodLimit {
  port in Boolean i, out Long o;

  automaton {
    state running;
    initial running;
    running {i == true} / {o = 3000000000L};
  }
}
