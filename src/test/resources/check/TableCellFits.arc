//// BadSwitch.arc
component BadSwitch {
  port in Boolean left, in Boolean right, out Integer speed;

  table {
    in left, right;
    out speed;
    | 3  | *    | => | 0 |;
//    ~ error ARC0336: input port 'left' takes Boolean, but '3' is of type Integer
    | *    | true | => | * |;
//                       ~ error ARC0336: '*' is for input cells; write the message that is sent, or '--' for none
  }
}

//// GoodSwitch.arc
component GoodSwitch {
  port in Boolean left, in Boolean right, out Integer speed;

  table {
    in left, right;
    out speed;
    | true | *    | => | 0 |;
    | *    | true | => | -- |;
  }
}

//// Sides.arc
component Sides {
  port in Boolean left, out Integer speed;

  table {
    in left;
    out speed;
    | alt {true, "a"} | => | alt {1, 2} |;
//               ~~~ error ARC0336: input port 'left' takes Boolean, but '"a"' is of type String
//                           ~~~~~~~~~~ error ARC0336: an output cell sends one message; 'alt' is for input cells
    | [true, false] | => | [1, 2] |;
//    ~~~~~~~~~~~~~ error ARC0336: a cell is about one message; write a single one
//                         ~~~~~~ error ARC0336: a cell is about one message; write a single one
  }
}

//// Kinds.arc
component Kinds {
  feature fast;
  port in Boolean left, out Integer speed;

  varif (fast) {
    table {
      in left;
      out speed;
      | 3 | => | 0 |;
//      ~ error ARC0336: input port 'left' takes Boolean, but '3' is of type Integer (in Kinds(fast = true))
    }
  } else {
    table {
      in left;
      out speed;
      | true | => | 1 |;
    }
  }
}
