//// Bad.arc
component Bad {
  port in Boolean tick, out Integer count, out Integer twice, out Integer more;

  var Integer sum = 0, limit = 9;

  automaton Counts {
    state counting;
    initial counting / {sum = 1};
    counting [sum < limit] {tick == true} / {sum = sum + 1, count = sum};
  }

  automaton Reads {
    state reading;
    initial reading;
    reading [sum < limit] / {twice = sum};
//           ~~~ error ARC0140: 'sum' changes with automaton 'Counts', and no other behaviour sees it; give this one a variable of its own, or write one automaton
//                                   ~~~ error ARC0140: 'sum' changes with automaton 'Counts', and no other behaviour sees it; give this one a variable of its own, or write one automaton
    reading {tick == true, sum == 1} / {sum = 2};
//                         ~~~ error ARC0140: 'sum' changes with automaton 'Counts', and no other behaviour sees it; give this one a variable of its own, or write one automaton
//                                      ~~~ error ARC0140: 'sum' changes with automaton 'Counts', and no other behaviour sees it; give this one a variable of its own, or write one automaton
  }

  table {
    in tick;
    out more;
    | true | => | sum |;
//                ~~~ error ARC0140: 'sum' changes with automaton 'Counts', and no other behaviour sees it; give this one a variable of its own, or write one automaton
    | *    | => | limit |;
  }
}

//// Good.arc
component Good {
  port in Boolean tick, out Integer count, out Integer twice;

  var Integer sum = 0, last = 0, limit = 9;

  automaton Counts {
    state counting;
    initial counting / {sum = 1};
    counting [sum < limit] {tick == true} / {sum = sum + 1, count = sum};
  }

  automaton Reads {
    state reading;
    initial reading;
    reading [last < limit] / {twice = last, last = last + 1};
  }
}
