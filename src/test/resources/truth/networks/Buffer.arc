package networks;

/** Passes every message on, a slice later. */
component Buffer<T> {
  port
    in T fresh,
    out T old;

  <<completion = "ignore">> automaton {
    state s;
    initial s;
    s {fresh == ?} / {old = fresh};
  }
}
