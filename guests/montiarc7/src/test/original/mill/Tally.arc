package mill;

import java.util.List;

/** Sums up what is large; lists are passed on, whatever is in them. */
component Tally {
  port in int a, in List<String> list;
  port out int sum, out List<String> copy;

  int total = 0;

  automaton {
    initial state Counting;

    Counting -> Counting [a > 3] a / { total += a; sum = total; };
    Counting -> Counting [a < 10] a / { sum = -a; }
    Counting -> Counting list / copy = list;;
  }
}
