component Tint {
  port sync in int a;
  Tinted tinted(NOTHING), plain;
}
