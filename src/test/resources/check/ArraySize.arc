//// Bad.arc
component Bad {
  port in Boolean a[0], in Boolean[0x101] b, out Boolean c;
//                ~~~~ error ARC0217: array 'a' has no element; write how many there are
//                                ~~~~~~~~~ error ARC0217: array 'b' has 257 elements, more than 256; divide it
  var Integer kept[0] = 1;
//            ~~~~~~~ error ARC0217: array 'kept' has no element; write how many there are

  automaton {
    variable Integer seen[1_000];
//                   ~~~~~~~~~~~ error ARC0217: array 'seen' has 1000 elements, more than 256; divide it
    state s;
    initial s / do {
      Integer local[0];
//            ~~~~~~~~ error ARC0217: array 'local' has no element; write how many there are
    };
    s {a[0] == true} / {c = true, kept[0] = 2, seen[9] = 1};
  }
}

//// Whole.arc
component Whole {
  port in Boolean x, out Boolean y;
  component Part part[0];
//               ~~~~~~~ error ARC0217: array 'part' has no element; write how many there are
  connect x -> part[0].x;
  connect part[0].y -> y;
}

//// Part.arc
component Part {
  port in Boolean x, out Boolean y;
}

//// Good.arc
component Good {
  port in Boolean[2] a, in Boolean b[256], out Boolean c[1];

  automaton {
    variable Integer seen[2] = 1;
    state s;
    initial s;
    s [a[1] == b[255]] / {c[0] = a[0], seen[1] = seen[0] + 1};
  }
}
