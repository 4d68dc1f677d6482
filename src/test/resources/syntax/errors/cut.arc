component A {
  automaton {
   state A;
