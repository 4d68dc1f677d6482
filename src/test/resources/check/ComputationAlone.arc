//// Beside.arc
component Beside {
  port in Integer i, out Integer o;

  compute {
    if (i != --) o = i;
  }

  automaton {
//~~~~~~~~~~~ error ARC0143: 'compute' says all that component 'Beside' does, so nothing stands beside it; write one of the two
    state s;
    initial s;
    s {i == ?} / {o = i};
  }
}

//// Twice.arc
component Twice {
  port in Integer i, out Integer o, out Integer p;

  var Integer first = 1;

  <<completion = "ignore">> compute {
    o = i + first;
  }

  init {
    first = 2;
//  ~~~~~ error ARC0140: 'first' changes with the first automaton that writes it, and no other behaviour sees it; give this one a variable of its own, or write one automaton
  }

  <<completion = "ignore">> compute More {
//                          ~~~~~~~ error ARC0143: component 'Twice' computes twice in a slice; write all statements into one 'compute'
    p = i;
  }

  init {
//~~~~ error ARC0143: component 'Twice' begins twice; write all statements into one 'init'
    o = 3;
  }
}

//// Begun.arc
component Begun {
  port in Integer i, out Integer o;

  init {
//~~~~ error ARC0143: 'init' is how a 'compute' begins, and there is none; an automaton has 'initial state / do {..};'
    o = 1;
  }

  automaton {
    state s;
    initial s;
    s {i == ?} / {o = i};
  }
}

//// GoodSum.arc
component GoodSum {
  port in Integer i, out Integer o;

  var Integer sum;

  init {
    sum = 1;
    o = sum;
  }

  <<completion = "ignore">> compute Sum {
    sum += i;
    if (sum > 9) {
      o = sum;
    }
  }
}

//// GoodWithoutStart.arc
component GoodWithoutStart {
  port in Integer i, out Integer o;

  compute {
    if (i == --) o = 0; else o = i;
  }
}

//// Wrong.arc
component Wrong {
  port in Integer i, out Integer o;

  compute {
    o = j;
//      ~ error ARC0329: 'j' is not a port, a variable or a parameter; declare it or correct the name
    if (i) o = 1;
//      ~ error ARC0341: a condition is true or false, but this is of type Integer; compare it with something
    i = 3;
//  ~ error ARC0307: nothing can be written to input port 'i': it only receives; name an output port or a variable
  }
}

//// Base.arc
component Base {
  port in Integer i, out Integer o;

  automaton {
    state s;
    initial s;
    s {i == ?} / {o = i};
  }
}

//// Heir.arc
component Heir extends Base {
  <<completion = "ignore">> compute {
//                          ~~~~~~~ error ARC0143: 'compute' says all that component 'Heir' does, but it inherits what 'Base' does; write one of the two
    o = i;
  }
}

//// GoodHeir.arc
component GoodHeir extends GoodWithoutStart {
  <<completion = "ignore">> compute {
    o = 2;
  }
}
