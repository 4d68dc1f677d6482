package networks;

import types.Signals.*;

/** What its heirs have in common. */
component Ancestor {
  port
    in Key key,
    in Integer number,
    out Key echo;
}
