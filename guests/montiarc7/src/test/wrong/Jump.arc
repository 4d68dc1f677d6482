component Jump {
  port sync in int a, sync out int b;
  compute {
    switch (a) { case 1: { if (a > 0) { break; } b = 2; } default: b = 3; }
  }
}
