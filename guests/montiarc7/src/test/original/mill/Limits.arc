package mill;

/** What Java's numbers have. */
component Limits {
  port sync in int a, b;
  port sync out int least, most, size;
  port sync out boolean full, empty;
  port sync out char letter;

  compute {
    least = Math.min(a, b + 1);
    most = Math.max(a, b);
    size = Math.abs(a - b);
    full = a == Integer.MAX_VALUE;
    if (b == 0) { empty = true; }
    if (b != 0) { empty = false; letter = 'x'; }
  }
}
