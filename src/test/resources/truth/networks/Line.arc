package networks;

import single.Decisions;
import single.Delayed;
import single.Mixed;
import types.Signals.*;

/** Fan-out, parts of parts, feedback through a delay, arguments handed down. */
component Line {
  port
    in Key key,
    in Boolean night,
    in Integer[0..9] level,
    out Light light,
    out Light second,
    out Boolean alarm,
    out Integer count;

  component Guarded(4) guarded;
  component Delayed delayed;
  component Decisions decisions;

  connect key -> delayed.key, decisions.key;
  connect night -> delayed.night;
  connect level -> guarded.level;
  connect guarded.alarm -> alarm, decisions.night;
  connect guarded.light -> second;
  connect decisions.light -> light;
  connect delayed.count -> count;

  component Guarded(Integer limit) {
    port
      in Integer[0..9] level,
      out Boolean alarm,
      out Light light;

    component Mixed(limit - 1) mixed;

    connect level -> mixed.level;
    connect mixed.alarm -> alarm;
    connect mixed.light -> light;
  }
}
