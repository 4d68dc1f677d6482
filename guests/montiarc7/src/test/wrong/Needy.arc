component Needy(int a, int b, int c = 3) {
  port sync in int level;
}
