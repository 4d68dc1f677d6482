component Open {
  port sync in int weight;
  Loose part(a = true);
}
