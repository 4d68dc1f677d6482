//// Bad.arc
component Bad(Integer limit) {
  port in Integer step, in Boolean go, out Integer count;

  automaton {
    variable Integer sum = 0;
    state counting;
    initial counting;
    counting / do {
      Integer step = 1, sum = 2;
//            ~~~~ error ARC0342: local variable 'step' is named like input port 'step'; rename it
//                      ~~~ error ARC0342: local variable 'sum' is named like variable 'sum'; rename it
      var Integer next = 3, limit = 4;
//                          ~~~~~ error ARC0342: local variable 'limit' is named like parameter 'limit'; rename it
      if (go) {
        Integer next = 4;
//              ~~~~ error ARC0342: local variable 'next' is named like local variable 'next'; rename it
        count = next;
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
      if (go) {
        Integer next = sum;
        count = next;
      } else {
        Boolean next = go;
        if (next) { sum = 1; }
      }
      { Integer next = 4; sum += next; }
      Integer next = 4, other = next;
      sum += other;
    };
  }
}
