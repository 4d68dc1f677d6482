package door.made;

/** A door with a motor. */
component Motor {
  port <<sync>> in int power, <<sync>> out int answer, <<sync>> out boolean stuck;

  automaton {
    initial state Down;
    state Up;

    Down -> Up [power > 0] / { answer = power; };
    Up -> Down [power < 0] / { answer = power; };
    Down -> Down [power < 0] / { stuck = true; };
    Up -> Up [power > 0] / { stuck = true; };
  }
}
