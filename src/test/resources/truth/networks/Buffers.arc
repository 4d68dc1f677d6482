package networks;

import types.Signals.*;

/** One generic component at two types. */
component Buffers {
  port
    in Key key,
    in Integer number,
    out Key oldKey,
    out Integer oldNumber;

  component Buffer<Key> keys;
  component Buffer<Integer> numbers;

  connect key -> keys.fresh;
  connect keys.old -> oldKey;
  connect number -> numbers.fresh;
  connect numbers.old -> oldNumber;
}
