//// BadAngles.arc
component BadAngles {
  port in Integer[0..017] angle, out Integer turn, out Long far;
//                   ~~~ warning ARC0348: '017' begins with 0 and is octal, as in Java: it is 15; write 15, or leave out the 0

  automaton {
    state s;
    initial s;
    s {angle == 010} / {turn = 0_10};
//              ~~~ warning ARC0348: '010' begins with 0 and is octal, as in Java: it is 8; write 8, or leave out the 0
//                             ~~~~ warning ARC0348: '0_10' begins with 0 and is octal, as in Java: it is 8; write 8, or leave out the 0
    s {angle == 011} / {turn = -0123, far = 0777L};
//              ~~~ warning ARC0348
//                              ~~~~ warning ARC0348: '0123' begins with 0 and is octal, as in Java: it is 83; write 83, or leave out the 0
//                                          ~~~~~ warning ARC0348: '0777L' begins with 0 and is octal, as in Java: it is 511; write 511L, or leave out the 0
  }
}

//// BadAnglesTest.mt
testsuite BadAnglesTest for BadAngles {
  test pads {
    input { angle: <010*Tk, 010, Tk>; }
//                  ~~~ warning ARC0348
//                          ~~~ warning ARC0348
    expect { turn: <9*Tk>; far: <9*Tk>; }
  }
}

//// GoodAngles.arc
/** 07 is 7 in any case; 010.5 and 010e1 are decimal, as in Java. */
component GoodAngles {
  port in Integer angle, out Integer turn, out Double ratio;

  automaton {
    state s;
    initial s;
    s {angle == 07} / {turn = 0, ratio = 010.5};
    s {angle == 00} / {turn = 0x10, ratio = 010e1};
  }
}
