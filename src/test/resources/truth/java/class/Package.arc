package java.class;

/** In a package whose name Java keeps for itself. */
component Package {
  timing instant;

  port
    in int java,
    out int class;

  automaton {
    state s;
    initial s;
    s {java == ?} / {class = java / 2};
  }
}
