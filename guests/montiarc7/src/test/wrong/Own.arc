component Own(Shelf Full) {
  port sync in int a, sync out int b;
  compute { Full.clear(); b = a; }
}
