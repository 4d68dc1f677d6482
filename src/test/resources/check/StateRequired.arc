//// BadRelay.arc
component BadRelay {
  port in Boolean i, out Boolean o;

  automaton Forward {
//          ~~~~~~~ error ARC0301: automaton 'Forward' has no state; declare its states with 'state a, b;'
  }
}

//// GoodRelay.arc
component GoodRelay {
  port in Boolean i, out Boolean o;

  automaton Forward {
    state forwarding;
    initial forwarding;
    forwarding {i == ?} / {o = i};
  }
}

//// Bare.arc
component Bare {
  port in Boolean i, out Boolean o;

  automaton {
//~~~~~~~~~ error ARC0301: the automaton has no state; declare its states with 'state a, b;'
    initial lost;
    lost {i == true} / {o = true};
  }
}
