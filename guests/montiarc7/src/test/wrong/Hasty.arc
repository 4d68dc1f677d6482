component Hasty {
  port sync in int a, sync out int b;
  int n = 0;

  automaton {
    initial state S { entry / { n = 1; b = n; } }
    state T;
    S -> T [n == 1];
  }
}
