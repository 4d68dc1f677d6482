package networks;

import single.Instant;
import types.Signals.*;

/** Ports by inheritance, connectors by name, an inner component that is its own instance. */
component Heir extends Ancestor {
  autoconnect port;

  port
    out Boolean large,
    out Integer doubled;

  component Instant;
}
