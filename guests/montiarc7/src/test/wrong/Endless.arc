component Endless {
  port sync in int a, sync out int b;
  int n = 0;
  compute { while (true) { n++; if (n == 1000) { b = n; } } }
}
