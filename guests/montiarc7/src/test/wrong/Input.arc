component Input {
  port sync in int a, sync out int[] b;
  init { a = 1; }
}
