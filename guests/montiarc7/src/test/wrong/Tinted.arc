component Tinted(Colour colour) {
  port sync in int a;
  varif (colour == Colour.RED) { port sync in int b; }
}
