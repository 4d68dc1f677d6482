component SomeStart {
  feature early;
  port sync out int b;
  int n = 0;
  varif (early) { init { n = 1; } }
  compute { b = n; }
}
