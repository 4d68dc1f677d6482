component Loose {
  feature a, b;
  port sync in int weight;
}
