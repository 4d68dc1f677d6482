//// Bad.arc
component Bad {
  port in Boolean tick, out Integer count;

  Integer sum = 0, limit;
//                 ~~~~~ error ARC0128: 'limit' is a constant and needs a value; if it changes, declare it as a 'variable' of the automaton

  automaton {
    state counting;
    initial counting / {sum = 1};
//                      ~~~ error ARC0128: 'sum' is a constant of the component and cannot be assigned; declare it as a 'variable' of the automaton
    counting {tick == true} / {sum = sum + 1, count = sum};
//                             ~~~ error ARC0128: 'sum' is a constant of the component and cannot be assigned; declare it as a 'variable' of the automaton
  }
}

//// Good.arc
component Good {
  port in Boolean tick, out Integer count;

  Integer step = 1;

  automaton {
    variable Integer sum = 0;

    state counting;
    initial counting;
    counting {tick == true} / {sum = sum + step, count = sum};
  }
}
