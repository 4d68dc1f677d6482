component Left {
  port sync in int a, sync out int b;
  int n = 0;
  compute { for (int i = 0; i < 3; i++) { n += i; if (a == i) { break; } } b = n; }
}
