package mill;

/** Turns that are calculated from each other, the last one first. */
component Gears {
    timing instant;
    Integer teeth = 3, spare = teeth + 1;
    /** Of the wheel in the water. */
    Integer inner = 2 + spare;
    /** Of the wheel in the mill. */
    Integer outer = inner * teeth;
    port out Integer turns;
    <<completion = "ignore">> compute {
        turns = outer;
    }
}
