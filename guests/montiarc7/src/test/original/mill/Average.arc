package mill;

/** The mean of the last two; nobody says what there is before the first. */
component Average(byte start) {
  port <<sync>> in byte value;
  port out int mean, <<delayed>> out int last;

  int before = start;

  init {
    last = -1;
  }

  <<sync>> compute {
    int sum = before + value;
    mean = sum / 2;
    if (value > before) {
      last = value;
    } else {
      last = before;
    }
    before = value;
  }
}
