//// BadBlink.arc
component BadBlink {
  port in Boolean press, out Boolean light;

  automaton {
    state ready;
    initial ready;
    ready {press == true} / {light = [true, false]};
//                                   ~~~~~~~~~~~~~ error ARC0314: a port carries one message in a slice, not 2; use further states, or 'timing untimed;' for the component
  }
}

//// GoodBlink.arc
component GoodBlink {
  port in Boolean press, out Boolean light;

  automaton {
    state ready, lit;
    initial ready;
    ready -> lit {press == true} / {light = true};
    lit -> ready / {light = false};
  }
}

//// Burst.arc
component Burst {
  timing untimed;
  port in Boolean press, out Boolean light;

  automaton {
    state ready;
    initial ready;
    ready {press == true} / {light = [true, false]};
  }
}

//// WaitsForTwo.arc
component WaitsForTwo {
  timing untimed;
  port in Boolean press, out Boolean light;

  automaton {
    state ready;
    initial ready;
    ready {press == [true, true]} / {light = true};
//                  ~~~~~~~~~~~~ error ARC0314: an untimed component handles one event at a time, not 2; wait for the first one, and in a state behind it for the next
  }
}
