package mill;

/** Has teeth, as many as usual where nobody says otherwise. */
component Wheel(int teeth = 12) {
  port <<sync>> in int turns, <<sync>> out int passed;

  <<sync>> compute { passed = turns * teeth; }
}
