component NoStart {
  automaton { state S; }
}
