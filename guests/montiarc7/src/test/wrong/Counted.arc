component Counted {
  port sync in int a, sync out int b;
  int n = 0;
  compute { int i = 0; while (i < 3) { n += i; if (a > i) { i++; } } b = n; }
}
