//// BadLimit.arc
component BadLimit {
  port in Integer speed, in Boolean brake, out Boolean slow;

  automaton {
    state running;
    initial running;
    running [speed && brake] {speed == ?} / {slow = true};
//           ~~~~~~~~~~~~~~ error ARC0330: '&&' needs two Booleans, not Integer and Boolean
  }
}

//// GoodLimit.arc
component GoodLimit {
  port in Integer speed, in Boolean brake, out Boolean slow;

  automaton {
    state running;
    initial running;
    running [speed > 0 && brake] {speed == ?} / {slow = true};
  }
}

//// Comparison.arc
component Comparison {
  port in Integer speed, in Boolean brake, out Boolean slow;

  automaton {
    state running;
    initial running;
    running [speed == brake] {speed == ?} / {slow = -brake};
//           ~~~~~~~~~~~~~~ error ARC0330: values of Integer and Boolean cannot be compared; they are never equal
//                                                  ~~~~~~ error ARC0330: '-' needs a number, but 'brake' has type Boolean
  }
}
