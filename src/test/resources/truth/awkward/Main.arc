package awkward;

import awkward.Words.*;

/** Parts with the names of methods, fields and classes. */
component Main {
  port
    in int class,
    in Object step,
    out Object state;

  component String step_;
  component String String;

  connect class -> step_.class, String.class;
  connect step -> step_.step, String.step;
  connect step_.state -> state;
}
