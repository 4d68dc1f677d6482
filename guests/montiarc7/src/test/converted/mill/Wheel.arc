package mill;

/** Has teeth, as many as usual where nobody says otherwise. */
component Wheel(Integer teeth = 12) {
    timing instant;
    port in Integer turns, out Integer passed;
    <<completion = "ignore">> compute {
        passed = turns * teeth;
    }
}
