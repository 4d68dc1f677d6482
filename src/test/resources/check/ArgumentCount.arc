//// Bad.arc
component Bad {
  port in Boolean start;

  component Timer(Integer slices, Boolean once = true) {
    port in Boolean start;
  }
  component Plain {
    port in Boolean start;
  }

  component Timer none;
//          ~~~~~ error ARC0117: component 'Timer' needs an argument for 'slices'; write it in parentheses behind 'Timer'
  component Timer(1, true, 3) three;
//                         ~ error ARC0117: component 'Timer' takes at most 2 arguments, but gets 3; delete what is too much
  component Plain(4) plain;
//                ~ error ARC0117: component 'Plain' takes no arguments, but gets 1; delete what is too much

  connect start -> none.start, three.start, plain.start;
}

//// Good.arc
component Good {
  port in Boolean start;

  component Timer(Integer slices, Boolean once = true) {
    port in Boolean start;
  }

  component Timer(1) one;
  component Timer(1, false) two;

  connect start -> one.start, two.start;
}
