//// Bad.arc
component Bad extends Base(hight = 2, low = 1) {
//                         ~~~~~ error ARC0134: component 'Base' has no parameter 'hight'; did you mean 'high'?
  component Inner(a = 1, aa = 2) first;
//                       ~~ error ARC0134: component 'Inner' has no parameter 'aa'; name one that it has
  component Inner(1, a = 2) second;
//                   ~~~~~ error ARC0134: parameter 'a' has an argument already; delete one
  component Inner(b = 1, 2) third;
//          ~~~~~ error ARC0117: component 'Inner' needs an argument for 'a'; write it in parentheses behind 'Inner'
//                       ~ error ARC0134: behind an argument with a name the place of one without tells nothing; write its name, or put it first
  component Inner(b = 1, b = 2, a = 3, zzzzz = 4) fourth;
//                       ~~~~~ error ARC0134: parameter 'b' has an argument already; delete one
//                              ~~~~~ error ARC0117: component 'Inner' takes at most 2 arguments, but gets 4; delete what is too much
//                                     ~~~~~ error ARC0134: component 'Inner' has no parameter 'zzzzz'; name one that it has

  component Inner(Integer a, Integer b = 2) {
  }
}

//// Base.arc
component Base(Integer low, Integer high = 9) {
}

//// BadTest.mt
testsuite BadTest for Base(low = 1, lower = 2) {
//                                  ~~~~~ error ARC0134: component 'Base' has no parameter 'lower'; name one that it has
  test nothing { }
}

//// GoodTest.mt
testsuite GoodTest for Base(high = 1, low = 2) {
  test nothing { }
}

//// Good.arc
component Good(Integer size = 4) extends Base(size, high = 2) {

  component Inner(b = size, a = 1) first;
  component Inner(1, b = 2) second;
  component Inner(a = 2) third;

  component Inner(Integer a, Integer b = 2) {
  }
}
