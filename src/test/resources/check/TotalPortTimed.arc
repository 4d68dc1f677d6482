//// BadUntimed.arc
component BadUntimed {
  timing untimed;
  port <<total>> in Boolean pressed, <<total>> out Boolean light;
//       ~~~~~ error ARC0339: port 'pressed' cannot carry a message in every slice: an untimed component knows no slices; remove 'total'
//                                     ~~~~~ error ARC0339: port 'light' cannot carry a message in every slice: an untimed component knows no slices; remove 'total'

  automaton {
    state only;
    initial only;
    only {pressed == true} / {light = true};
  }
}

//// GoodSlices.arc
component GoodSlices {
  port <<total>> in Boolean pressed, <<total>> out Boolean light;

  automaton {
    state only;
    initial only / {light = false};
    only {pressed == true} / {light = true};
    only {pressed == false} / {light = false};
  }
}

//// GoodEvents.arc
component GoodEvents {
  timing untimed;
  port in Boolean pressed, out Boolean light;

  automaton {
    state only;
    initial only;
    only {pressed == true} / {light = true};
  }
}
