//// BadDoubler.arc
component BadDoubler {
  port in Integer i, out Integer o;

  init Start {
//~~~~ warning ARC0127
    counter = 0;
  }

  compute {
//~~~~~~~ warning ARC0127: Java code in 'compute' is not run; describe the behaviour with an automaton or a table, or mark the component <<platform>> and write its Java class by hand
    o = twice(i);
  }
}

//// GoodDoubler.arc
component GoodDoubler {
  port in Integer i, out Integer o;

  automaton {
    state s;
    initial s;
    s {i == ?} / {o = i};
  }
}

//// Made.arc
component Made {
  port in Integer i, out Integer o;

  init {
//~~~~ warning ARC0127
    List<Integer> all = new ArrayList<Integer>();
  }

  compute {
//~~~~~~~ warning ARC0127
    o = i;
  }
}

//// Looped.arc
component Looped {
  port in Integer i, out Integer o;

  compute {
//~~~~~~~ warning ARC0127
    for (int k = 0; k < i; k++) { o = k; }
  }
}

//// GoodStatements.arc
component GoodStatements {
  port in Integer i, out Integer o;

  compute {
    if (i != --) { o = 2 * i; }
  }
}
