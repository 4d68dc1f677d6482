component Loop {
  port sync in int a, sync out int b;

  compute {
    for (int i = 0; i < a; i++) { b = i; }
  }
}
