package single;

/** A guard behind an enabled one is not evaluated: with b = 0 it would divide by zero. */
component Guarded {
  port
    in Integer[0..3] a, b,
    out Integer quotient;

  <<completion = "ignore">> automaton {
    state s;
    initial s;

    s {b == 0} / {quotient = 0};
    s [a / b > 1] / {quotient = a / b};
    s [a % b == 0] / {quotient = 1};
  }
}
