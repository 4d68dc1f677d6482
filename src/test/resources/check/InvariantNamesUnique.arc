//// Bad.arc
component Bad {
  port in Integer a, out Integer b;
  ocl inv small: a < 10;
//        ~~~~~ warning ARC0132
  java inv small: { return b < 10; };
//         ~~~~~ warning ARC0132
//         ~~~~~ error ARC0216: component 'Bad' has an invariant 'small' already; rename one of them
}

//// Good.arc
component Good {
  ocl inv small: a < 10;
//        ~~~~~ warning ARC0132
  component Inner {
    ocl inv small: a < 10;
//          ~~~~~ warning ARC0132
  }
}
