//// BadLimit.arc
component BadLimit {
  port in Integer speed, out Integer cmd;

  automaton {
    state running;
    initial running;
    running [speed - 3] {speed == ?} / {cmd = 3};
//           ~~~~~~~~~ error ARC0315: a guard is true or false, but this is of type Integer; compare it with something
  }
}

//// GoodLimit.arc
component GoodLimit {
  port in Integer speed, out Integer cmd;

  automaton {
    state running;
    initial running;
    running [speed > 3] {speed == ?} / {cmd = 3};
  }
}
