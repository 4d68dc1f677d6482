package single;

/** Every kind of number, with Java's arithmetic: overflow, shortening, division towards zero. */
component Numbers {
  timing instant;

  port
    in Integer a,
    in Long b,
    in Double c,
    in byte d,
    out Integer sum,
    out Long product,
    out Double ratio,
    out byte small,
    out float single,
    out Integer rest;

  <<completion = "ignore">> automaton {
    variable Integer seed = 2147483000;
    variable Long wide = 9000000000L;
    state s;
    initial s;

    s [a % 2 == 0 && d != 0] / {
      sum = a + seed, product = wide * b, small = (byte) (d * 3), rest = a % d, seed = seed + a
    };
    s [c > 0.5] / {ratio = c / 3, single = (float) c, sum = (int) c, wide = wide + (long) c};
    s [a % 2 != 0] / {sum = -a, rest = ~a, product = a - 1};
  }
}
