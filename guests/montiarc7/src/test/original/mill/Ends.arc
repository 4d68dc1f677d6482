package mill;

component Ends<T> {
  port sync in T input;
  port sync out T output;
}
