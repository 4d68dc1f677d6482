package events;

import types.Signals.*;

/** Several messages wait at one part for each other's turn, and a latch that feeds itself. */
component Meeting {
  timing untimed;

  port
    in Key key,
    <<state>> in Integer level,
    out Integer sum,
    out Light light;

  component Split split;
  component Join join;
  component Memory memory;

  connect key -> split.key, join.key;
  connect level -> split.level;
  connect split.left -> join.left;
  connect split.right -> join.right, memory.number;
  connect memory.next -> memory.last;
  connect join.sum -> sum;
  connect join.light -> light;

  component Split {
    timing untimed;

    port
      in Key key,
      <<state>> in Integer level,
      out Integer left, right;

    automaton {
      variable Integer count;
      state s;

      initial s / {left = [1, 2], right = 5};

      s {key == up} / {left = [level, count, level + count], right = [count], count = count + 1};
      s [level > 3] {key == down} / {right = [level, level], left = 9};
      s [level == --] {key == down} / {right = 77};
      s {key == hold} / {count = 0};
    }
  }

  component Join {
    timing untimed;

    port
      in Integer left, right,
      in Key key,
      out Integer sum,
      out Light light;

    <<completion = "error">> automaton {
      variable Integer total;
      state open, busy;

      initial open;

      open {left == ?} / {total = total + left, sum = total};
      open -> busy {right == ?} / {sum = [right, total], light = [green, red]};
      open {key == ?};
      busy {left == ?} / {sum = -left};
      busy -> open {right == ?};
      busy {key == alt {up, hold}};
      busy {key == down} / {light = yellow};
    }
  }

  component Memory {
    timing untimed;

    port
      in Integer number,
      <<state>> in Integer last,
      out Integer next;

    <<completion = "ignore">> automaton {
      state s;
      initial s;
      s {number == ?} / {next = number + 1};
      s [last > 5] {number == ?} / {next = 0};
    }
  }
}
