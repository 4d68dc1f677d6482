component Variant(int size) {
  feature f;
  varif (size > 3) { port sync in int a; }
}
