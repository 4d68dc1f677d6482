component Closed {
  port sync in int a;
  component Inner {
    port sync in int weight;
    Loose part(a = true);
  }
}
