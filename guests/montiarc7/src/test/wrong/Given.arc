component Given {
  port sync in Painted door, sync out int b;
  compute { Painted same = door; Painter.paint(same); b = door.coats; }
}
