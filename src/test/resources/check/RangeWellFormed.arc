//// BadLimit.arc
component BadLimit {
  port in Integer[9..0] speed, out Double[0..1] share;
//               ~~~~~~ error ARC0332: the range is empty; write the lower end first
//                                       ~~~~~~ error ARC0332: only whole number types have ranges

  automaton {
    state running;
    initial running;
    running {speed == ?} / {share = 0.5};
  }
}

//// GoodLimit.arc
component GoodLimit {
  port in Integer[0..9] speed, out Double share;

  automaton {
    state running;
    initial running;
    running {speed == ?} / {share = 0.5};
  }
}
