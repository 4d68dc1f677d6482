//// BadSwitch.arc
component BadSwitch {
  port in Boolean left, in Boolean right, out Integer speed;

  table {
    in left, rigth;
//           ~~~~~ error ARC0334: component 'BadSwitch' has no port 'rigth'; did you mean 'right'?
    out speed;
    | true | *    | => | 0 |;
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

//// WrongSide.arc
component WrongSide {
  port in Boolean left, in Boolean right, out Integer speed;

  table {
    in left, speed;
//           ~~~~~ error ARC0334: 'speed' is an output port; list it behind 'out'
    out speed;
    | true | 0 | => | 0 |;
  }
}

//// Twice.arc
component Twice {
  port in Boolean left, in Boolean right, out Integer speed;

  table {
    in left, left;
//           ~~~~ error ARC0334: 'left' is a column already; remove one
    out speed;
    | true | false | => | 0 |;
  }
}

//// GoodKeys.arc
component GoodKeys {
  port in Boolean key[3], out Integer speed;

  table {
    in key[0x0], key[ 1 ], key[02];
    out speed;
    | true | *    | "a|b;" == "=>" |  => | 0 |; // a row | with signs => in it;
    | *    | /* | ; => */ true | * | => | 1 |;
  }
}
