component Missing {
  port sync in Painted door, sync out int b;
  compute { b = door.rooms; }
}
