package maps;

component B {
  port sync in int c, sync out int b;

  automaton { initial state T; state U; T -> U / { b = c; }; }
}
