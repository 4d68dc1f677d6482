component Twice {
  port sync in int a, sync out int b;

  automaton {
    initial state S { entry / { b = 1; } }
    S -> S / { if (a > 1) { b = 2; } else { b = 3; } };
  }
}
