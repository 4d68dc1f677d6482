//// Bad.arc
  <<total>> component Bad {
//  ~~~~~ error ARC0503: stereotype 'total' means nothing on a component; it belongs on a port
  port <<layer = "sensors">> in Boolean i, <<omitted = "free">> out Boolean o;
//       ~~~~~~~~~~~~~~~~~ error ARC0503
//                                           ~~~~~~~~~~~~~~~~ error ARC0503: stereotype 'omitted' means nothing on a port; it belongs on a behaviour

  <<deploy>> automaton {
//  ~~~~~~ error ARC0503
    state <<state>> s;
//          ~~~~~ error ARC0503
    initial s / {o = false};
    s {i == true} / {o = true};
  }
}

//// Good.arc
<<suppress = "ARC1001: name of 2012">> component Good {
  <<total>> port in Boolean i, out Boolean o;

  <<omitted = "free">> automaton {
    state s;
    initial s / {o = false};
    s {i == true} / {o = true};
  }
}
