component Switch(boolean loud, boolean late, int n) {
  port sync in int a, sync out boolean b;
  varif (loud) { port sync in int c; }
  varif (late) { port sync in int d; }
  compute { b = loud; }
}
