//// Bad.arc
<<layer = "logik", capacity = "many">> component Bad {
//        ~~~~~~~ error ARC0502: stereotype 'layer' has no value 'logik'; it can be "sensors", "logic" or "actuators"
//                 ~~~~~~~~~~~~~~~~~ error ARC0502: stereotype 'capacity' needs a whole number from 1 to 999999 as its value
  port <<total = "yes">> in Boolean i;
//               ~~~~~ error ARC0502: stereotype 'total' takes no value; delete it
  port <<delay>> out Boolean o;
//       ~~~~~ error ARC0502: stereotype 'delay' needs a value: "0" or "1"

  <<violated = "stopp">> automaton {
//             ~~~~~~~ error ARC0502: stereotype 'violated' has no value 'stopp'; it can be "stop" or "continue"
    state s;
    initial s;
  }
  <<completion = chos>> automaton {
//               ~~~~ error ARC0502: stereotype 'completion' has no value 'chos'; it can be "chaos", "output", "ignore" or "error"
    state s;
    initial s;
    s {i == true} / {o = true};
  }
}

//// Reasons.arc
<<breaks, breaks = " ", replaces = "p.Old", replaces = "p.Old: ">> component Reasons {
//~~~~~~ error ARC0502: stereotype 'breaks' needs a reason, as in <<breaks = "reason">>
//        ~~~~~~~~~~~~ error ARC0502
//                      ~~~~~~~~~~~~~~~~~~ error ARC0502: stereotype 'replaces' needs the name of a component that is gone and a reason, as in <<replaces = "p.Robot: reason">>
//                                          ~~~~~~~~~~~~~~~~~~~~ error ARC0502
  port in Boolean i;
}

//// Good.arc
<<layer = "logic", capacity = "32", breaks = "why not", replaces = "p.Old: renamed">> component Good {
  port <<total>> in Boolean i;
  port <<delay = "0">> out Boolean o;

  <<completion = chaos, omitted = "free", violated = "continue">> automaton {
    state s;
    initial s;
    s {i == true} / {o = true};
  }
}
