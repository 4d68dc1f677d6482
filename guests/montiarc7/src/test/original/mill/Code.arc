package mill;

/** What Java does with bits. */
component Code {
  port sync in int a, b, sync in long c, sync in boolean p, q;
  port sync out int low, half, more, upper, other;
  port sync out long far;
  port sync out boolean both, one, any, high, same, clear;
  port sync out boolean over, none, some, differ;

  compute {
    low = a & 7;
    half = a >> 1;
    more = a << 30;
    upper = a >>> 28;
    other = ~(a + b);
    far = c >>> 31;
    both = p & q;
    one = p ^ q;
    any = p | q;
    high = (a | b) >>> 3 != 0;
    same = (a ^ b) == 0;
    clear = (a | c) == 0;
    int sum = a + b;
    over = 0 > ((a ^ sum) & (b ^ sum));
    none = (a | b) >= 0;
    some = 0 <= (a & b);
    differ = (a ^ c) < 0;
  }
}
