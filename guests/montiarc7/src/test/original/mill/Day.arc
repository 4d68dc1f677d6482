package mill;

/** Has one mode, in which it stays. */
component Day {
  port sync in int i, sync out int o;
  sync mode automaton {
    initial mode Always {
      Pass<Integer> pass;
      i -> pass.i;
      pass.o -> o;
    }
  }
}
