component Belt(boolean slow) {
  varif (slow) { port sync in int a; }
}
