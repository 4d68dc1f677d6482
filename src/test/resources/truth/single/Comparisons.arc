package single;

import types.Signals.*;

/** Ports compared with ports: two silent ones are not equal. */
component Comparisons {
  timing instant;

  port
    in Key left, right,
    in Integer number,
    out Key same,
    out Integer count;

  automaton {
    variable Key last;
    state s;
    initial s;

    s {left == right, right == left} / {same = left, last = right};
    s {left == left, number == number} / {count = number};
    s [left != right] / {same = right, last = left};
    s [left == (if number > 3 then right else last)] / {count = 1};
    s {right == last} / {count = 2};
    s [number == number && right == right] / {count = 3};
    s {left == alt {right, last}} / {count = 4};
    s [left == left] / {count = 5};
  }
}
