package networks;

/** A constant of a composite, made from its parameter, is an argument of its parts. */
component Constants(Integer limit) {
  port
    in Integer number,
    out Integer scaled;

  Integer twice = limit * 2;
  Integer more = twice + 1;

  component Scale(more - limit) scale;

  connect number -> scale.number;
  connect scale.scaled -> scaled;

  component Scale(Integer factor) {
    timing instant;

    port
      in Integer number,
      out Integer scaled;

    <<completion = "ignore">> automaton {
      state s;
      initial s;
      s {number == ?} / {scaled = number * factor};
    }
  }
}
