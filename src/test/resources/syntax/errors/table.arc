component Drive {
  port in Boolean a[2], in Integer b, out Integer c;

  table {
    in a[0], a[1] b;
    out c
    | true | * | 1 | => | 2 |;
    | true | * | 2 => | 3 |;
    | true | * | 3 | => | 4 |
    | * | * | 4 | => | 5 + |;
    | * | * | 5 | -> | 6 |;
    * | * | 6 | => | 7 |;
    | * | * | 7 | => | alt {8, 9} | ;
    | * | == 8 | 9 | => | 10 |;
    | * | * | 9 | => 11 |;
    | * | * | 10 | => | 12; |
    row 12;
    | * | * | 12 | => | -- |;
  }
}
