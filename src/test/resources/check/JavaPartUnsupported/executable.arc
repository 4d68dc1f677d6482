// profile: executable
//// BadDoubler.arc
component BadDoubler {
  port in Integer i, out Integer o;

  init Start {
//~~~~ error ARC0127: 'init' is taken for Java with what stands beside it, and is not run
    counter = 0;
  }

  compute {
    o = twice(i);
//      ~~~~~~~~ error ARC0127: 'twice(i)' cannot stand here in statements, so all of 'compute' is taken for Java, which is not run; correct it, describe the behaviour with an automaton or a table, or mark the component <<platform>> and write its Java class by hand
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
