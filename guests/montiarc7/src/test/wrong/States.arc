component States {
  port sync in int a;

  automaton {
    initial state S { state T; }
    state T;
    T -> U;
  }
}
