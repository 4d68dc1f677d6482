package events;

/**
 * Messages run in a circle until they are used up, or flood a queue. The network says
 * nothing about its timing: it is what its parts are.
 */
component Circle {
  port
    in Integer number,
    out Integer passed;

  component Enter enter;
  component Lower first, second;

  connect number -> enter.fresh;
  connect enter.all -> first.number;
  connect first.lower -> second.number;
  connect second.lower -> enter.back, passed;

  component Enter {
    timing untimed;

    port
      in Integer fresh, back,
      out Integer all;

    <<completion = "error">> automaton {
      state s;
      initial s / {all = [2, 1]};
      s {fresh == ?} / {all = fresh};
      s {back == ?} / {all = back};
    }
  }

  component Lower {
    timing untimed;

    port
      in Integer number,
      out Integer lower;

    <<completion = "ignore">> automaton {
      state s;
      initial s;
      s [number > 0] {number == ?} / {lower = number - 1};
      s {number == -6} / {lower = [-6, -6]};
      s {number == -7} / {lower = [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17]};
    }
  }
}
