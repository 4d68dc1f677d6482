//// BadDoubler.arc
component BadDoubler {
  port in Integer i, out Integer o;

  init Start {
//~~~~ warning ARC0127: 'init' is taken for Java with what stands beside it, and is not run
    counter = 0;
  }

  compute {
    o = twice(i);
//      ~~~~~~~~ warning ARC0127: 'twice(i)' cannot stand here in statements, so all of 'compute' is taken for Java, which is not run; correct it, describe the behaviour with an automaton or a table, or mark the component <<platform>> and write its Java class by hand
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
    List<Integer> all = new ArrayList<Integer>();
//  ~~~~~~~~~~~~~ warning ARC0127: 'List<Integer>' cannot stand here in statements, so all of 'init' is taken for Java, which is not run; correct it, describe the behaviour with an automaton or a table, or mark the component <<platform>> and write its Java class by hand
  }

  compute {
//~~~~~~~ warning ARC0127: 'compute' is taken for Java with what stands beside it, and is not run
    o = i;
  }
}

//// Looped.arc
component Looped {
  port in Integer i, out Integer o;

  compute {
    for (int k = 0; k < i; k++) { o = k; }
//      ~ warning ARC0127: '(' cannot stand here in statements, so all of 'compute' is taken for Java, which is not run; correct it, describe the behaviour with an automaton or a table, or mark the component <<platform>> and write its Java class by hand
  }
}

//// GoodStatements.arc
component GoodStatements {
  port in Integer i, out Integer o;

  compute {
    if (i != --) { o = 2 * i; }
  }
}

//// Misspelt.arc
component Misspelt {
  port in Integer i, out Integer o;

  init {
//~~~~ warning ARC0127: 'init' is taken for Java with what stands beside it, and is not run
    o = 1;
  }

  compute {
    if (i > 3) {
      o = i;
    } esle {
//         ~ warning ARC0127: '{' cannot stand here in statements, so all of 'compute' is taken for Java, which is not run; correct it, describe the behaviour with an automaton or a table, or mark the component <<platform>> and write its Java class by hand
      o == 4;
    }
  }
}
