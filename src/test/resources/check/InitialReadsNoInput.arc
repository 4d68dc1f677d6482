//// BadRelay.arc
component BadRelay {
  port in Boolean i, out Boolean o;

  automaton {
    state forwarding;
    initial forwarding / {o = i};
//                            ~ error ARC0309: input port 'i' cannot be read before the first slice; write a constant or a parameter
    forwarding {i == ?} / {o = i};
  }
}

//// GoodRelay.arc
component GoodRelay {
  port in Boolean i, out Boolean o;

  automaton {
    state forwarding;
    initial forwarding / {o = false};
    forwarding {i == ?} / {o = i};
  }
}

//// InVariable.arc
component InVariable {
  port in Boolean i, out Boolean o;

  automaton {
    variable Boolean last = i;
//                          ~ error ARC0309: input port 'i' cannot be read before the first slice; write a constant or a parameter
    state forwarding;
    initial forwarding / {o = false};
    forwarding {i == ?} / {o = last, last = i};
  }
}
