component Distance {
  port sync in double a, sync out double b;

  compute { b = Math.abs(a); }
}
