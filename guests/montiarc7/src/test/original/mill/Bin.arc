package mill;

/** Keeps what it gets for a slice. */
component Bin<T extends Grain>(T first) {
  port <<sync>> in T i, <<causalsync>> out T o;

  init { o = first; }

  compute { o = i; }
}
