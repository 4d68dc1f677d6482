package events;

/** One message takes two ways into a composition, which cross inside: a part gets it twice. */
component Crossing {
  timing untimed;

  port in Integer x, out Integer y;

  component Pair pair;

  connect x -> pair.a, pair.b;
  connect pair.y -> y;

  component Pair {
    timing untimed;

    port in Integer a, b, out Integer y;

    component Inner inner;

    connect a -> inner.second;
    connect b -> inner.first;
    connect inner.y -> y;
  }

  component Inner {
    timing untimed;

    port in Integer first, second, out Integer y;

    component Weigh weigh;

    connect second -> weigh.tens;
    connect first -> weigh.ones;
    connect weigh.y -> y;
  }

  /** Shows on which input a message came first. */
  component Weigh {
    timing untimed;

    port in Integer ones, tens, out Integer y;

    automaton {
      variable Integer last;
      state s;

      initial s;

      s {ones == ?} / {y = 2 * last + ones, last = ones};
      s {tens == ?} / {y = 3 * last + 10 * tens, last = tens};
    }
  }
}
