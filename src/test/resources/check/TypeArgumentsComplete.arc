//// p/Bad.arc
package p;
component Bad {
  port in Integer speed;

  component Buffer<T> {
    port in T i;
  }
  component Motor {
    port in Integer power;
  }

  component Buffer one;
//          ~~~~~~ error ARC0115: component 'Buffer' takes 1 type argument, but gets 0; write one type for each type parameter
  component Buffer<Integer, Boolean> two;
//          ~~~~~~ error ARC0115: component 'Buffer' takes 1 type argument, but gets 2; write one type for each type parameter
  component Motor<Integer> motor;
//          ~~~~~ error ARC0115: component 'Motor' takes no type arguments; delete them
  component Buffer<?> any;
//                 ~ error ARC0115: a wildcard is no type; write the type of the messages of 'Buffer'

  connect speed -> one.i, two.i, motor.power, any.i;
}

//// p/Pair.arc
package p;
component Pair<A, B> {
  port in A a, in B b;
}

//// p/BadHeir.arc
package p;
component BadHeir extends Pair<Integer> {
//                        ~~~~ error ARC0115: component 'Pair' takes 2 type arguments, but gets 1; write one type for each type parameter
  port in Integer c;
}

//// p/BadNamed.arc
package p;
component BadNamed {
  port in Integer i;
  component Buffer<T> buffer {
//                    ~~~~~~ error ARC0115: component 'Buffer' takes 1 type argument, but gets 0; write one type for each type parameter
    port in T i;
  }
  connect i -> buffer.i;
}

//// p/Good.arc
package p;
component Good {
  port in Integer speed;

  component Buffer<T> {
    port in T i;
  }

  component Buffer<Integer> buffer;

  connect speed -> buffer.i;
}
