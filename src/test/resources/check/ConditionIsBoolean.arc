//// Bad.arc
component Bad {
  port in Integer step, in Boolean go, out Integer count;

  automaton {
    variable Integer sum = 0;
    state counting;
    initial counting;
    counting / do {
      if (step + 1) {
//        ~~~~~~~~ error ARC0341: a condition is true or false, but this is of type Integer; compare it with something
        sum++;
      } else if (go) {
        sum--;
      }
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
