package networks;

/**
 * Two composites that need each other's instant outputs: as wholes they form a circle, their parts do
 * not. Generated code has to take them apart.
 */
component Crossing {
  port
    in Integer a,
    out Integer b,
    out Integer remembered;

  component Pair first, second;
  component Last last;

  connect a -> first.left;
  connect first.leftDone -> second.left;
  connect second.leftDone -> first.right;
  connect first.rightDone -> second.right;
  connect second.rightDone -> b, last.number;
  connect last.previous -> remembered;

  component Pair {
    port
      in Integer left, right,
      out Integer leftDone, rightDone;

    component Increment(1) up;
    component Increment(-3) down;

    connect left -> up.number;
    connect up.next -> leftDone;
    connect right -> down.number;
    connect down.next -> rightDone;
  }

  component Increment(Integer by) {
    timing instant;

    port
      in Integer number,
      out Integer next;

    <<completion = "ignore">> automaton {
      state s;
      initial s;
      s {number == ?} / {next = number + by};
    }
  }

  component Last {
    port
      in Integer number,
      out Integer previous;

    <<completion = "ignore">> automaton {
      state s;
      initial s / {previous = 0};
      s {number == ?} / {previous = number};
      s {number == --} / {previous = --};
    }
  }
}
