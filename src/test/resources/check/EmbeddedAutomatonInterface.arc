//// BadRelay.arc
component BadRelay {
  port in Boolean i, out Boolean o;

  automaton {
    input Boolean other;
//  ~~~~~~~~~~~~~~~~~~~~ error ARC0324: an automaton inside a component uses the component's ports; move this input to the ports of 'BadRelay'
    state forwarding;
    initial forwarding;
    forwarding {i == ?} / {o = i};
  }
}

//// GoodRelay.arc
component GoodRelay {
  port in Boolean i, in Boolean other, out Boolean o;

  automaton {
    state forwarding;
    initial forwarding;
    forwarding {i == ?} / {o = i};
  }
}
