//// BadSwitch.arc
component BadSwitch {
  port in Boolean left, in Boolean right, out Integer speed;

  table {
    in left, right;
    out speed;
    | true | => | 0 |;
//  ~~~~~~~~~~~~~~~~~~ error ARC0335: the row has 1 input cell for 2 input columns; give each column one cell, '*' where an input does not matter and '--' where nothing is sent
    | *    | true | => | 1 |;
  }
}

//// GoodSwitch.arc
component GoodSwitch {
  port in Boolean left, in Boolean right, out Integer speed;

  table {
    in left, right;
    out speed;
    | true | *    | => | 0 |;
    | *    | true | => | 1 |;
  }
}
