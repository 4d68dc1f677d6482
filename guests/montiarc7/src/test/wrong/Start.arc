component Start {
  port sync in int a, sync out int b;

  automaton {
    initial { b = 0; } state S;
    S -> S / { b = a; };
  }
}
