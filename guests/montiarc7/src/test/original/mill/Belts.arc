package mill;

/** Three belts, of which one is there in slow mills only. */
component Belts(boolean slow) {
  feature easy;
  port sync in int i, sync out int o, sync out int waiting;

  constraint (slow || !easy);
  varif (slow) {
    port sync out int late;
    Belt last(9, true);
    i -> last.i;
    last.o -> late;
  }

  Belt first(5), second(slow = easy, most = 7);

  i -> first.i, second.i;
  first.o -> o;
  second.o -> waiting;
}
