package mill;

/** Sums up the digits of a number, in slices. */
component Digits {
  port sync in int number, sync out int sum, sync out boolean even;

  compute {
    int rest = number;
    int total = 0;
    for (int i = 0; i < 4; i++) {
      total += rest % 10;
      rest /= 10;
      if (i == 3) { sum = total; }
    }
    for (int i = 3; i < 3; i++) { sum = 0; }
    if (total % 2 == 0) { for (int i = 0; i < 1; i++) even = true; }
  }
}
