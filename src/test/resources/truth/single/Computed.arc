package single;

/** What is computed in each slice: one after the other, with choices, from what the slice before has left. */
component Computed {
  port
    <<total>> in Integer[0..9] weight,
    in Boolean tare,
    <<total>> out Integer sum,
    out Integer[0..9] heavy;

  var Integer total;
  var Integer[0..9] found = 0;

  init {
    total = 1;
    sum = total;
  }

  <<completion = "error">> compute {
    var Integer before = total;
    total += weight;
    if (tare == true) {
      total = total - before;
      found = 0;
    } else if (weight > 4 && found < 9) {
      found++;
      heavy = found;
    }
    total = total % 1000;
    sum = total + before;
  }
}
