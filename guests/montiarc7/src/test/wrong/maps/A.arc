package maps;

component A {
  port sync in int a, sync out int b;

  automaton { initial state S; state R; S -> R / { b = a; }; }
}
