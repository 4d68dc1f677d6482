//// Bad.arc
component Bad(Integer size = true) {
//                           ~~~~ error ARC0118: parameter 'size' is of type Integer, but this value is of type Boolean
  port in Boolean start;

  component Timer(Integer[1..9] slices, Boolean once = false) {
    port in Boolean start;
  }

  component Timer("two") text;
//                ~~~~~ error ARC0118: parameter 'slices' is of type Integer[1..9], but this value is of type String
  component Timer(10) large;
//                ~~ error ARC0322
  component Timer(2, size) number;
//                   ~~~~ error ARC0118: parameter 'once' is of type Boolean, but this value is of type Integer

  connect start -> text.start, large.start, number.start;
}

//// Good.arc
component Good(Integer[1..9] size = 3, Boolean loop = true) {
  port in Boolean start;

  component Timer(Integer slices, Boolean once = false) {
    port in Boolean start;
  }

  component Timer(2) two;
  component Timer(size + 1, !loop) more;

  connect start -> two.start, more.start;
}
