component Dyed(Colour colour, Colour other) {
  port sync in int a;
  varif (colour == Colour.RED) { port sync in int b; }
  varif (other == colour) { port sync in int c; }
}
