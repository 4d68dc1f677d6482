component Switched {
  port sync in int a;
  Belt left, right(a > 3);
}
