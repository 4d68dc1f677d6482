package networks;

/** Some values are wrong before the first slice: the run stops in it and says which. */
component WrongStart(Integer limit) {
  port
    in Integer number,
    out Integer scaled;

  component Start(limit) start;

  connect number -> start.number;
  connect start.scaled -> scaled;

  component Start(Integer limit) {
    port
      in Integer number,
      out Integer scaled;

    Integer third = 9 / (limit + 1);

    <<completion = "ignore">> automaton {
      variable Integer[0..5] twice = limit * third;
      state s;
      initial s / {scaled = twice};
    }
  }
}
