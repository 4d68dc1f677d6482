component SomeDelay {
  feature late;
  port sync in int a, sync out int b;
  varif (late) {
    <<delayed>> compute { b = a; }
  } else {
    compute { b = a; }
  }
}
