//// BadGuard.arc
component BadGuard {
  timing instant;
  port in Boolean tooClose, out Boolean drive;

  automaton {
    state driving;
    initial driving / {drive = true};
//                     ~~~~~~~~~~~~ error ARC0321: output port 'drive' has no delay: its first message already answers the first input; drop the initial output or delay the port with <<delay = "1">>
    driving {tooClose == true} / {drive = false};
  }
}

//// GoodGuard.arc
component GoodGuard {
  timing delayed;
  port in Boolean tooClose, out Boolean drive;

  automaton {
    state driving;
    initial driving / {drive = true};
    driving {tooClose == true} / {drive = false};
  }
}

//// OnePort.arc
component OnePort {
  timing instant;
  port in Boolean tooClose, out Boolean drive, <<delay = "1">> out Boolean lamp;

  automaton {
    state driving;
    initial driving / {drive = true, lamp = false};
//                     ~~~~~~~~~~~~ error ARC0321: output port 'drive' has no delay: its first message already answers the first input; drop the initial output or delay the port with <<delay = "1">>
    driving {tooClose == true} / {drive = false};
  }
}

//// Asked.arc
component Asked {
  timing instant;
  port in Boolean i, out Boolean o;
  component Passes p;
  connect i -> p.i;
  connect p.o -> o;

  automaton {
    state s;
    initial s / {o = true};
//               ~~~~~~~~ error ARC0321: output port 'o' has no delay: its first message already answers the first input; drop the initial output or delay the port with <<delay = "1">>
    s {i == ?} / {o = i};
  }
}

//// Passes.arc
component Passes {
  timing instant;
  port in Boolean i, out Boolean o;

  automaton {
    state s;
    initial s;
    s {i == ?} / {o = i};
  }
}
