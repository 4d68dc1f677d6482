package mill;

/** Turns that are calculated from each other, the last one first. */
component Gears {
  /** Of the wheel in the mill. */
  int outer = inner * teeth;
  int teeth = 3, spare = teeth + 1;

  /** Of the wheel in the water. */
  int inner = 2 + spare;

  port sync out int turns;

  compute { turns = outer; }
}
