//// robot/BadBufferTest.mt
package robot;

testsuite BadBufferTest for Buffer {
//                          ~~~~~~ error ARC0705: component 'Buffer' needs a value for 'first'; write it in parentheses behind the name
  test keeps {
    input { value: <4>; }
  }
}

//// robot/GoodBufferTest.mt
package robot;

testsuite GoodBufferTest for Buffer(3) {
  test keeps {
    input { value: <4>; }
  }
}

//// robot/TooMany.mt
package robot;

testsuite TooMany for Buffer(3, true, 4) {
//                              ~~~~ error ARC0705: parameter 'limit' takes Integer, but 'true' is of type Boolean
//                                    ~ error ARC0705: component 'Buffer' has 2 parameters; remove this argument
  test keeps {
    input { value: <4>; }
  }
}

//// robot/Generic.mt
package robot;

testsuite Generic for Cell {
//                    ~~~~ error ARC0705: component 'Cell' needs type arguments, which a suite cannot give; test a component that uses it with given types
  test keeps {
  }
}

//// robot/Cell.arc
package robot;

component Cell<T> {
  port in T value, out T last;

  automaton {
    state keeping;
    initial keeping;
    keeping {value == ?} / {last = value};
  }
}

//// robot/Buffer.arc
package robot;

component Buffer(Integer first, Integer limit = 9) {
  port in Integer value, out Integer last;

  automaton {
    state keeping;
    initial keeping / {last = first};
    keeping {value == ?} / {last = value};
  }
}
