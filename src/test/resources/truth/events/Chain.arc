package events;

import types.Signals.*;

/** A network of queues: one event sets off many. */
component Chain {
  timing untimed;

  port
    in Key key,
    <<state>> in Boolean night,
    out Integer sum,
    out Light light;

  component Counter counter;
  component Sum adder;

  connect key -> counter.key;
  connect night -> counter.night;
  connect counter.number -> adder.number;
  connect counter.light -> light;
  connect adder.sum -> sum;

  component Sum {
    timing untimed;

    port
      in Integer number,
      out Integer sum;

    <<completion = "ignore">> automaton {
      variable Integer total;
      state s;
      initial s;
      s [number != 2] {number == ?} / {total = total + number, sum = total + number};
      s {number == 2} / {sum = [total, total]};
    }
  }
}
