//// BadMean.arc
component BadMean {
  port in Integer sum, out Integer mean;

  automaton {
    state running;
    initial running;
    running {sum == ?} / {mean = sum / 0};
//                                     ~ error ARC0323: division by zero would stop the run; correct the divisor
  }
}

//// GoodMean.arc
component GoodMean {
  port in Integer sum, out Integer mean;

  automaton {
    state running;
    initial running;
    running {sum == ?} / {mean = sum / 2};
  }
}

//// Remainder.arc
component Remainder {
  port in Integer sum, in Double real, out Integer mean, out Double infinite;

  automaton {
    state running;
    initial running;
    running [sum % 0 == 1] {sum == ?, real == ?} / {mean = 1, infinite = real / 0.0};
//                 ~ error ARC0323: division by zero would stop the run; correct the divisor
  }
}

//// Computed.arc
component Computed(Integer size = 8 / (3 - 3)) {
//                                     ~~~~~ error ARC0323: division by zero would stop the run; correct the divisor
  port in Integer sum, out Integer mean;

  automaton {
    state running;
    variable Integer left = 1 / (2 * 0 + 1);
    initial running;
    running {sum == ?} / {mean = sum / size, left = 1 % (7 / 8)};
//                                                       ~~~~~ error ARC0323: division by zero would stop the run; correct the divisor
  }
}

//// ComputedTest.mt
testsuite ComputedTest for Computed(4 / (5 - 5)) {
//                                       ~~~~~ error ARC0323: division by zero would stop the run; correct the divisor
  test mean {
    input { sum: <8>; }
  }
}

//// UncertainTest.mt
testsuite UncertainTest for Computed(4 / (if 1 > 2 then 1 else 0)) {
//                                        ~~~~~~~~~~~~~~~~~~~~~~ error ARC0323: whether this divisor is zero shows only in a run; write the number
  test mean {
    input { sum: <8>; }
  }
}

//// Wrapped.arc
component Wrapped {
  port in Integer sum, in Long large, out Integer mean, out Long share;

  automaton {
    state running;
    initial running;
    running {sum == ?} / {mean = sum / (2147483647 + 2147483647 + 2)};
//                                      ~~~~~~~~~~~~~~~~~~~~~~~~~~~ error ARC0323: division by zero would stop the run; correct the divisor
    running {large == ?} / {share = large / (2147483647L + 2147483647L + 2L)};
  }
}
