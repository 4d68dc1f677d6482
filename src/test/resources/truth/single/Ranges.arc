package single;

/** Ranges end a run where a value leaves them; so does a division by zero. */
component Ranges {
  port
    in Integer[0..3] step,
    in Integer[-2..2] divisor,
    out Integer[0..20] level,
    out Integer quotient;

  <<completion = "ignore">> automaton {
    variable Integer[0..20] total = 0;
    state filling, draining;

    initial filling / {level = 0};

    filling [total < 16] {step == ?} / {total = total + step, level = total};
    filling -> draining [total >= 16];
    draining [divisor != 1] / {quotient = total / divisor, total = total - step};
    draining -> filling {divisor == 1} / {level = total};
  }
}
