//// BadOrder.arc
/* The line ends here ‮ } */
//                    ~ warning ARC0219: the character '\u202e' (right-to-left override) changes the order in which this line is shown; remove it
component BadOrder {
  port in String a, out String b;

  automaton {
    state s;
    initial s;
    s {a == "x⁦y"} / {b = "plain"};
//            ~ warning ARC0219: the character '\u2066' (left-to-right isolate) changes the order in which this line is shown; write \u2066
  }
}

//// GoodOrder.arc
/** Letters that are written from right to left are fine: שלום. */
component GoodOrder {
  port in String a, out String b;

  automaton {
    state s;
    initial s;
    s {a == "\u202e"} / {b = "שלום"};
  }
}
