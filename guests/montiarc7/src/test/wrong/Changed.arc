component Changed {
  port sync in int a, sync out int b;
  Painted door = null;
  compute { door.coats = a; b = door.coats; }
}
