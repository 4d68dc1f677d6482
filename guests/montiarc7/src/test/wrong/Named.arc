component Named {
  port in int a, out int b;
  int n = 0;

  automaton {
    initial state S;
    S -> S a / { { int m = n; b = m; } { int m = 2; b = m; } }
  }
}
