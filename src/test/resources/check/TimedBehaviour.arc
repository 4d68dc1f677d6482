//// Bad.arc
component Bad {
  behavior timed;
//~~~~~~~~~~~~~~~ error ARC0146: in 'timed' a slice may bring several messages on one port, which no behaviour means here; write 'causalsync' where one is enough, or 'untimed' where slices say nothing
  port in Boolean press, out Boolean light;

  automaton {
    state off;
    initial off;
    off {press == true} / {light = true};
  }
}

//// Good.arc
component Good {
  timing timed;
  port in Boolean press, out Boolean light;

  component Door timed;

  connect press -> timed.press;
  connect timed.light -> light;
}

//// Door.arc
component Door {
  behavior timed;
  port in Boolean press, out Boolean light;
}
