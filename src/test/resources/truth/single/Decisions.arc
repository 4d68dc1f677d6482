package single;

import types.Signals.*;

/** A stateless behaviour: the first row that fits. */
component Decisions {
  timing instant;

  port
    in Key key,
    in Boolean night,
    out Light light,
    out Integer level;

  table {
    in key, night;
    out light, level;
    | up | true  | => | green  | 1  |;
    | up | --    | => | green  | -- |;
    | ?  | false | => | yellow | 2  |;
    | -- | ?     | => | --     | 3  |;
    | *  | *     | => | red    | 4  |;
  }
}
