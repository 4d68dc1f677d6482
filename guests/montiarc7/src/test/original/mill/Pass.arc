package mill;
component Pass<T> {
  port sync in T i; port sync out T o;
  compute { o = i; }
}
