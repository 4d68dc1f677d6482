/* A licence. */
package mill;

import mill.Signals.Switch;
import java.util.List;

/** Opens and closes. */
component Gate(int most = 3) {
  port <<sync>> in Switch press, <<sync>> in boolean blocked;
  port <<sync>> out boolean open, <<sync, delayed>> out int count;

  int opened = 0;

  automaton {
    initial { count = 0; } state Shut;
    // while it is open
    state Open {
      entry / { open = true; }
      exit / { opened++; }
      initial state Wide;
      state Narrow;
      Wide -> Narrow [press == Switch.ON && opened > 1] / { count = opened; };
    };
    Shut -> Open [press == Switch.ON && opened < most];
    Shut -> Shut [press == Switch.ON] / {
      int left = most - opened;
      if (left < 0) { count = left; } else { count = opened; }
    };
    Open -> Shut [blocked || press == Switch.OFF] / { opened += 1; count = opened; }
  }
}
