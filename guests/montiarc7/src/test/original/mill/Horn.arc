package mill;

/** A horn, with a pipe or two. */
component Horn {
  feature low, high;
  port sync in int i, sync out int o;

  constraint (low || high);
  varif (low && high) {
    compute { o = 2 * i; }
  } else {
    compute { o = i; }
  }
}
