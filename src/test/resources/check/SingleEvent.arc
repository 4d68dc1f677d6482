//// BadDoorbell.arc
component BadDoorbell {
  timing untimed;
  port in Boolean button, in Boolean door, out Boolean bell;

  automaton {
    state idle;
    initial idle;
    idle {button == true, door == true} / {bell = true};
//       ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ error ARC0320: an untimed component handles one event at a time, but this waits for 'button', 'door' at once; write one for each, or mark a port whose last value is meant with <<state>>
  }
}

//// GoodDoorbell.arc
component GoodDoorbell {
  timing untimed;
  port in Boolean button, <<state>> in Boolean door, out Boolean bell;

  automaton {
    state idle;
    initial idle;
    idle {button == true, door == true} / {bell = true};
  }
}

//// NoEvent.arc
component NoEvent {
  timing untimed;
  port in Boolean button, out Boolean bell;

  automaton {
    state idle, ringing;
    initial idle;
    idle -> ringing {button == true} / {bell = true};
    ringing -> idle / {bell = false};
//  ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ error ARC0320: an untimed component does nothing without an event; name the message that triggers this
  }
}

//// LatchedOnly.arc
component LatchedOnly {
  timing untimed;
  port in Boolean button, <<state>> in Boolean door, out Boolean bell;

  automaton {
    state idle;
    initial idle;
    idle {door == true} / {bell = true};
//       ~~~~~~~~~~~~~~ error ARC0320: an untimed component does nothing without an event; name the message that triggers this
  }
}

//// BadTable.arc
component BadTable {
  timing untimed;
  port in Boolean button, in Boolean door, <<state>> in Integer floor, out Boolean bell;

  table {
    in button, door, floor;
    out bell;
    | true | --    | 3 | => | true  |;
    | *    | false | * | => | false |;
    | true | true  | * | => | true  |;
//  ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ error ARC0320: an untimed component handles one event at a time, but this waits for 'button', 'door' at once; write one for each, or mark a port whose last value is meant with <<state>>
    | *    | --    | 3 | => | false |;
//  ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ error ARC0320: an untimed component does nothing without an event; name the message that triggers this
  }
}
