component Rounds {
  port sync in int a, sync out int b;
  compute { for (int i = 0; i < 3; i++) { b = i; } }
}
