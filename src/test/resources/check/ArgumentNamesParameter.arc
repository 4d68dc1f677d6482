//// Bad.arc
component Bad extends Base(3, hight = 2, high = 4, 1) {
  component Inner(a = 1, aa = 2) first;
  component Inner(1, a = 2) second;
  component Inner(b = 1, 2) third;
  component Inner(b = 1, b = 2, a = 3, zzzzz = 4) fourth;

  component Inner(Integer a, Integer b = 2) {
    port in Integer x;
  }
}

//// Base.arc
component Base(Integer low, Integer high = 9) {
  port in Integer x;
}

//// BadTest.mt
testsuite BadTest for Base(low = 1, lower = 2) {
  test nothing { }
}

//// GoodTest.mt
testsuite GoodTest for Base(high = 1, low = 2) {
  test nothing { }
}

//// Good.arc
component Good(Integer size = 4) extends Base(size, high = 2) {
  port in Integer y;

  component Inner(b = size, a = 1) first;
  component Inner(1, b = 2) second;
  component Inner(a = 2) third;

  component Inner(Integer a, Integer b = 2) {
    port in Integer x;
  }

  connect y -> first.x, second.x, third.x;
}
