package awkward;

import awkward.Words.*;

/** Names that Java has taken already. */
component String {
  port
    in int class,
    in Object step,
    out Object state,
    out boolean Main,
    out int main;

  <<completion = "ignore">> automaton {
    variable int taken, this_, choice = 1;
    state while, While, WHILE, INITIAL;

    initial while / {state = int_};

    while -> While {step == public} / {state = Public, taken = taken + choice};
    While -> WHILE {step == Public, class == ?} / {main = class + taken, Main = true};
    WHILE -> INITIAL {step == int_} / {state = step};
    INITIAL -> while / {main = this_};
  }
}
