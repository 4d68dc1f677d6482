component Bitwise {
  port sync in int a, b, sync out int c, sync out boolean d;

  compute {
    c = a & b;
    c = a & 6;
    c = a | 1;
    c = a << b;
    c = a >> 31;
    c = a ^ b;
    d = ((a & b) | a) == 0;
    d = (a ^ b) >>> 2 == 0;
    d = ~(a + 1.5) == 0;
  }
}
