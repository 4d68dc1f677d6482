component Variant {
  feature f, g;
  constraint (f implies g);
  varif (f) { port in int a; } else port out int b;
}
