package events;

/** Where a step leaves a range and floods a queue as well, the range is first: all is computed before. */
component Overflow {
  port
    in Integer number;

  component Sender sender;
  component Narrow narrow;

  connect number -> sender.number;
  connect sender.copy -> narrow.one, narrow.other;

  component Sender {
    timing untimed;

    port
      in Integer number,
      out Integer[0..5] copy;

    <<completion = "ignore">> automaton {
      variable Integer[0..3] count;
      state s;
      initial s;
      s [number > 0] {number == ?} / {copy = 1, count = count + number};
      s [number <= 0] {number == ?} / {copy = [2, number]};
    }
  }

  <<capacity = "1">> component Narrow {
    timing untimed;

    port
      in Integer[0..5] one, other;

    <<completion = "ignore">> automaton {
      state s;
      initial s;
    }
  }
}
