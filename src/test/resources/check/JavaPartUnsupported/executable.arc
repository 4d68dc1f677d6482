// profile: executable
//// BadDoubler.arc
component BadDoubler {
  port in Integer i, out Integer o;

  init Start {
//~~~~ error ARC0127
    counter = 0;
  }

  compute {
//~~~~~~~ error ARC0127: Java code in 'compute' is not run; describe the behaviour with an automaton or a table, or mark the component <<platform>> and write its Java class by hand
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
