//// Colour.cd
classdiagram Colour {
  enum Light { red, green }
}

//// BadPair.arc
import Colour.*;
component BadPair {
  port in Boolean p, out Boolean lit, out Integer n, out Light light, out String text;

  automaton one {
    state s;
    initial s / {lit = true, n = 1 + 1};
  }

  automaton two {
    state s;
    initial s / {lit = false};
//               ~~~~~~~~~~~ warning ARC0356: another automaton of this component begins with another message on 'lit', so there is no run that both allow; let them begin alike
  }

  automaton three {
    state s;
    initial s / do { n = 2; n = 3; };
//                          ~~~~~~ warning ARC0356
  }

  automaton four {
    state s;
    initial s / {light = red, n = 2};
//                            ~~~~~ warning ARC0356
  }

  automaton five {
    state s;
    initial s / {light = Light.green, text = "--"};
//               ~~~~~~~~~~~~~~~~~~~ warning ARC0356
  }

  automaton six {
    state s;
    initial s / {text = --};
//               ~~~~~~~~~ warning ARC0356
  }
}

//// BadStarts.arc
component BadStarts {
  port in Boolean p, out Integer n;

  automaton one {
    state a, b;
    initial a / {n = 1};
    initial b / {n = 2};
  }

  automaton two {
    state a, b;
    initial a / {n = 3};
//               ~~~~~ warning ARC0356
    initial b / {n = -1};
  }
}

//// BadWhole.arc
component BadWhole {
  port in Boolean p, out Boolean lit;
  component Lamp {
    port in Boolean p, out Boolean lit;
  }
  connect p -> lamp.p;
  connect lamp.lit -> lit;

  automaton one { state s; initial s / {lit = true}; }
  automaton two { state s; initial s / {lit = false}; }
//                                      ~~~~~~~~~~~ warning ARC0356
}

//// GoodPair.arc
component GoodPair(Integer start = 2) {
  timing delayed;
  port in Boolean p, out Boolean lit, out Integer n, out Double d, <<delay = "0">> out Boolean now;

  automaton one {
    state a, b;
    initial a / {lit = true, n = 1, d = 0.1};
    initial b / {lit = false, n = 1, d = 0.1};
  }

  automaton two {
    state s;
    initial s / {lit = false, n = start, d = 0.2};
  }

  automaton three {
    state s;
    initial s;
  }

  automaton four {
    state s;
    initial s / do { n = 4; n = 1; };
  }
}

//// GoodEvents.arc
component GoodEvents {
  timing untimed;
  port in Boolean p, out Integer n;
  automaton one { state s; initial s / {n = 1}; }
  automaton two { state s; initial s / {n = 2}; }
}
