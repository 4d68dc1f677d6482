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
