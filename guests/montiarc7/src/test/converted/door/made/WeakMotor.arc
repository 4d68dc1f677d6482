package door.made;

/** A door with a motor. */
component WeakMotor {
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
            answer = 0;
        };
        Up -> Up [power > 5 && !(power < 0)] / do {
            stuck = true;
        };
    }
}
