package door.made;

/** A door with a motor. */
component Motor {
    timing instant;
    port in Integer power, out Integer answer, out Boolean stuck;
    <<completion = "ignore">> automaton {
        state Down, Up;
        initial Down;
        Down -> Up [power > 0] / do {
            answer = power;
        };
        Down -> Down [power < 0] / do {
            stuck = true;
        };
        Up -> Down [power < 0] / do {
            answer = power;
        };
        Up -> Up [power > 0] / do {
            stuck = true;
        };
    }
}
