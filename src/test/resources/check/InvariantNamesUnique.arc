//// Bad.arc
component Bad {
  port in Integer a, out Integer b;
  ocl inv small: a < 10;
  java inv small: { return b < 10; };
//         ~~~~~ warning ARC0132
//         ~~~~~ warning ARC0216: component 'Bad' has an invariant 'small' already, so that this one is told as 'small#2'; rename one of them
  inv small: a > 2;
//    ~~~~~ warning ARC0216: component 'Bad' has an invariant 'small' already, so that this one is told as 'small#3'; rename one of them
}

//// Good.arc
component Good {
  port in Integer a;
  ocl inv small: a < 10;
  component Inner {
    port in Integer a;
    ocl inv small: a < 10;
  }
  connect a -> inner.a;
}
