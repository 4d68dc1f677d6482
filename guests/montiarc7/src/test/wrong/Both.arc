component Both {
  port in int a, out int b;

  automaton {
    initial state S;
    S -> S a / { b = a; };
    S -> S / { b = 0; };
  }
}
