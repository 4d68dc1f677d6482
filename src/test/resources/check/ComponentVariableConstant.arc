//// Bad.arc
component Bad {
  port in Boolean tick, out Integer count;

  Integer sum, limit;
//             ~~~~~ error ARC0128: 'limit' is written by no automaton of the component, so it is a constant and needs a value

  automaton {
    state counting;
    initial counting / {sum = 1};
    counting [sum < limit] {tick == true} / {sum = sum + 1, count = sum};
  }
}

//// Good.arc
component Good {
  port in Boolean tick, out Integer count;

  Integer step = 1, sum;

  automaton {
    state counting;
    initial counting;
    counting {tick == true} / {sum = sum + step, count = sum};
  }
}

//// Compute.arc
component Compute {
  port in Boolean tick, out Integer count;

  int sum;

  compute {
    count = next(sum);
//          ~~~~~~~~~ warning ARC0127: 'next(sum)' cannot stand here in statements, so all of 'compute' is taken for Java, which is not run; correct it, describe the behaviour with an automaton or a table, or mark the component <<platform>> and write its Java class by hand
  }
}

//// Computed.arc
component Computed {
  port in Boolean tick, out Integer count;

  int sum;

  compute {
    sum++;
    count = sum;
  }
}

//// Brand.arc
component Brand {
  port in Boolean tick, out Integer count;

  var Integer sum;
//            ~~~ error ARC0128: 'sum' is written by no automaton of the component, so it is a constant and needs a value

  automaton {
    variable Integer other = 0;
    state counting;
    initial counting;
    counting {tick == true} / {other = sum};
  }
}

//// GoodSilent.arc
component GoodSilent {
  port in Boolean tick, out Integer count;

  Integer sum, limit;
}

//// BadHeir.arc
component BadHeir extends GoodSilent {
//                        ~~~~~~~~~~ error ARC0128: 'limit' of 'GoodSilent' is written by no automaton of this component, so it is a constant and needs a value
  automaton {
    state counting;
    initial counting;
    counting [sum < limit] {tick == true} / {sum = sum + 1, count = sum};
  }
}

//// GoodHeir.arc
component GoodHeir extends GoodSilent {
  automaton {
    state counting;
    initial counting / {limit = 3};
    counting [sum < limit] {tick == true} / {sum = sum + 1, count = sum};
  }
}

//// GoodSilentHeir.arc
component GoodSilentHeir extends GoodSilent {
  String name;
}

//// BelowHeir.arc
component BelowHeir extends BadHeir {
}

//// Reads.arc
component Reads {
  port in Boolean tick, out Integer count;

  Integer limit, twice = 2 * limit;
//        ~~~~~ error ARC0128: 'limit' is written by no automaton of the component, so it is a constant and needs a value
}
