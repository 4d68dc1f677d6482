component Table {
    port in Integer a, in Boolean b, out Cmd c, out Integer d;
    <<completion = "ignore">> table {
        in a, b;
        out c, d;
        | 1 | true | => | fwd | 2 |;
        | * | -- | => | -- | a + 1 |;
        | alt {1, 2} | ? | => | stop | [1, 2] |;
    }
    table { out c; | => | fwd |; }
}
