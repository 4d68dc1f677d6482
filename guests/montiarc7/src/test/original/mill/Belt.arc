package mill;

/** Carries at once, or first onto a heap; how much it carries is another matter. */
component Belt(int most, boolean slow = false) {
  port sync in int i, sync out int o;

  varif (slow) {
    Bin<Integer> heap(0);
    i -> heap.i;
    heap.o -> o;
  } else {
    compute { o = i < most ? i : most; }
  }
}
