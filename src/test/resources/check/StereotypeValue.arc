//// Bad.arc
<<layer = "logik", capacity = "many">> component Bad {
//        ~~~~~~~ error ARC0502: stereotype 'layer' has no value 'logik'; it can be "sensors", "logic" or "actuators"
//                 ~~~~~~~~~~~~~~~~~ error ARC0502: stereotype 'capacity' needs a whole number from 1 to 999999 as its value
  port <<total = "yes">> in Boolean i;
//               ~~~~~ error ARC0502: stereotype 'total' takes no value; delete it
  port <<delay>> out Boolean o;
//       ~~~~~ error ARC0502: stereotype 'delay' needs a value: "0" or "1"

  <<completion = chos>> automaton {
//               ~~~~ error ARC0502: stereotype 'completion' has no value 'chos'; it can be "chaos", "output", "ignore" or "error"
    state s;
    initial s;
    s {i == true} / {o = true};
  }
}

//// Good.arc
<<layer = "logic", capacity = "32">> component Good {
  port <<total>> in Boolean i;
  port <<delay = "0">> out Boolean o;

  <<completion = chaos, omitted = "free">> automaton {
    state s;
    initial s;
    s {i == true} / {o = true};
  }
}
