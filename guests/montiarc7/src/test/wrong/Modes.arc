component Modes {
  mode automaton {
    initial mode A { x -> y; }
    mode B { }
    A -> B [true];
  }
}
