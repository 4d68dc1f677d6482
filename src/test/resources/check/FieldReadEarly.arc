//// Bad.arc
component Bad {
  port in Boolean tick, out Integer count;

  var Integer sum = 0, next = sum + 1;
//                            ~~~ error ARC0141: 'sum' changes while the component runs, and this is computed before; read a constant or a parameter

  automaton {
    variable Integer other = sum;
//                           ~~~ error ARC0141: 'sum' changes while the component runs, and this is computed before; read a constant or a parameter
    state counting;
    initial counting;
    counting {tick == true} / {sum = other + next, count = sum};
  }
}

//// Part.arc
component Part(Integer from) {
  port in Boolean tick, out Integer count;
}

//// BadPart.arc
component BadPart {
  port in Boolean tick, out Integer count;

  var Integer sum = 0;

  component Part(sum) part;
//               ~~~ error ARC0141: 'sum' changes while the component runs, and this is computed before; read a constant or a parameter

  connect tick -> part.tick;
  connect part.count -> count;

  automaton {
    state counting;
    initial counting;
    counting {tick == true} / {sum = sum + 1, count = sum};
  }
}

//// Good.arc
component Good(Integer from) {
  port in Boolean tick, out Integer count;

  var Integer step = from, sum = step;

  automaton {
    variable Integer other = step;
    state counting;
    initial counting / {sum = sum + 1};
    counting [sum > 0] {tick == true} / {sum = sum + other, count = sum};
  }
}
