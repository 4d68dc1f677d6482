component Many {
  port in int a, out int b, out boolean c;
  int n = 0;

  automaton {
    initial state S;
    S -> S a / {
      b = 0;
      if (n > 1) { b = 1; }
      if (n > 2) { b = 2; }
      if (n > 3) { b = 3; }
      if (n > 4) { b = 4; }
      if (n > 5) { b = 5; }
      if (n > 6) { b = 6; }
      if (n > 7) { b = 7; }
    }
  }
}
