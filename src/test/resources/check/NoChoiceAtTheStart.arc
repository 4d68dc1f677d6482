//// Bad.arc
component Bad(Boolean late) {
  port in Integer step, in Boolean go, out Integer count;

  automaton {
    variable Integer sum = 0;
    state counting;
    initial counting / do {
      if (late) { sum = 1; }
//        ~~~~ error ARC0344: nothing is decided before the first slice; write 'if condition then value else value' as a value, or decide in a transition
    };
    counting / do {
      sum = step;
    };
  }
}

//// Good.arc
component Good(Boolean late) {
  port in Integer step, in Boolean go, out Integer count;

  automaton {
    variable Integer sum = 0;
    state counting;
    initial counting / do { sum = if late then 1 else 2; count = sum; sum = 0; };
    counting / do {
      Integer next = sum + step;
      if (next > 3 && go) {
        count = next;
      }
      sum = next;
    };
  }
}
