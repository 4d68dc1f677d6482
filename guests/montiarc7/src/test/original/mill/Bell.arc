package mill;

/** Strikes, more than once for most questions. */
component Bell {
  port in int ask;
  port out int strike, out boolean late;

  int all = 0;

  automaton {
    initial { strike = all; strike = -1; } state Ready { entry / { strike = all; all = 5; } }

    // Known beforehand.
    Ready -> Ready [ask == 1] ask / {
      for (int a = 0; a < 6; a++) {
        if (a == 2) { continue; }
        if (a > 3) break;
        strike = a;
      }
    }
    // What is sent changes afterwards.
    Ready -> Ready [ask == 2] ask / {
      int left = 3;
      while (left > 0) {
        all += left;
        strike = all;
        left--;
      }
    }
    // Each round has its own sum.
    Ready -> Ready [ask == 3] ask / {
      for (int a = 0, by = 1; ; a++, by *= 2) {
        if (!(a < 3)) break;
        int sum = a + all;
        sum++;
        strike = sum * by;
      }
    }
    Ready -> Ready [ask == 4] ask / {
      int a = 1;
      do {
        for (long b = 0; b < 2; b++) { strike = 10 * a + 1; }
        a++;
      } while (a <= 2);
    }
    // One, two or three.
    Ready -> Ready [ask > 4] ask / {
      if (ask > 6) strike = 1;
      { int more = ask + 1; strike = more; }
      if (ask > 6) { late = true; strike = 2; } else { late = false; }
      if (ask == 9) strike = 9;
      if (ask == 5 || ask == 7) strike = 5;
    }
    Ready -> Ready [ask == 0] ask / {
      int a = 0;
      while (a < 3) strike = a++;
      all = all++;
      strike = --all;
    }
    // What is not there is not sent.
    Ready -> Ready [ask < 0] ask / {
      strike = null;
      strike = ask;
      switch (ask) {
        case -1: strike = 11;
        case -2: late = true;
        default: strike = 12;
      }
    }
  }
}
