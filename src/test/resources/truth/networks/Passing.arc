package networks;

import types.Signals.*;

/** Messages that pass straight through, to several receivers, and parts that only pass on. */
component Passing {
  port
    in Key key,
    in Integer number,
    out Key straight, twice, again,
    out Integer echo;

  component Wire first, second;
  component Nested nested;

  connect key -> first.in, straight;
  connect first.out -> second.in;
  connect second.out -> twice, again;
  connect number -> nested.number;
  connect nested.echo -> echo;

  component Wire {
    port
      in Key in,
      out Key out;

    connect in -> out;
  }

  component Nested {
    port
      in Integer number,
      out Integer echo;

    component Buffer<Integer> buffer;

    connect number -> buffer.fresh;
    connect buffer.old -> echo;
  }
}
