//// Bad.arc
component Bad {
  port in Integer step, in Boolean go, out Integer count;

  automaton {
    variable Integer sum = 0;
    state counting;
    initial counting;
    counting / do {
      Integer[0..9] next = sum;
//           ~~~~~~ error ARC0343: a local variable has no range: only what is kept or sent in the end is looked at; leave the range out
      count = next;
    };
  }
}

//// Good.arc
component Good {
  port in Integer step, in Boolean go, out Integer count;

  automaton {
    variable Integer sum = 0;
    state counting;
    initial counting;
    counting / do {
      Integer next = sum + step;
      if (next > 3 && go) {
        count = next;
      }
      sum = next;
    };
  }
}
