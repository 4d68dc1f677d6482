package mill;

/** Two bins in a row. */
component Bins {
  port sync in int i, sync out int o;

  Bin<Integer> left(1), right(2);

  i -> left.i;
  left.o -> right.i;
  right.o -> o;
}
