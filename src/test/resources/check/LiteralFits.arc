//// BadLimit.arc
component BadLimit {
  port in Boolean i, out Long o;

  automaton {
    state running;
    initial running;
    running {i == true} / {o = 3000000000};
//                             ~~~~~~~~~~ error ARC0331: '3000000000' is too large for Integer; append L for a Long
  }
}

//// GoodLimit.arc
component GoodLimit {
  port in Boolean i, out Long o;

  automaton {
    state running;
    initial running;
    running {i == true} / {o = 3000000000L};
  }
}

//// BadPadding.arc
component BadPadding {
  port in Integer[0..09] a, out Integer b, out Long c, in Boolean go[08];
//                   ~~ error ARC0331: '09' begins with 0 and is octal, as in Java, where there is no digit 8 or 9; write 9
//                                                                   ~~ error ARC0331: '08' begins with 0 and is octal, as in Java, where there is no digit 8 or 9; write 8

  automaton {
    state s;
    initial s;
    s {a == 08} / {b = -0_19, c = 0098L};
//          ~~ error ARC0331: '08' begins with 0 and is octal, as in Java, where there is no digit 8 or 9; write 8
//                      ~~~~ error ARC0331: '0_19' begins with 0 and is octal, as in Java, where there is no digit 8 or 9; write 19
//                                ~~~~~ error ARC0331: '0098L' begins with 0 and is octal, as in Java, where there is no digit 8 or 9; write 98L
  }
}

//// BadReal.arc
component BadReal {
  port in Double a, out float b, out Double c;

  automaton {
    state s;
    initial s;
    s {a == 1e-400} / {b = 1e-50f, c = 0x1p-1075};
//          ~~~~~~ error ARC0331: '1e-400' is too small for Double and would be 0; write 0 or a larger number
//                         ~~~~~~ error ARC0331: '1e-50f' is too small for float and would be 0; write 0 or a larger number
//                                     ~~~~~~~~~ error ARC0331: '0x1p-1075' is too small for Double and would be 0; write 0 or a larger number
    s {a == 1e400} / {b = 1e39f, c = 0x1p1024};
//          ~~~~~ error ARC0331: '1e400' is too large for Double
//                        ~~~~~ error ARC0331: '1e39f' is too large for float
//                                   ~~~~~~~~ error ARC0331: '0x1p1024' is too large for Double
  }
}

//// GoodReal.arc
/** Each form that Java has for a number, and zeros, however they are written. */
component GoodReal {
  port in Double a, in Integer[0..5] n, out float b, out Double c;

  automaton {
    state s;
    initial s;
    s [exists i in {0..3, 5}: n == i] {a == 5.} / {b = 5.f, c = 0x1p3};
    s [n isin {1}] {a == .5} / {b = 1f, c = 0x1.8p-2};
    s [n isin {2}] {a == 1e3} / {b = 0x.8p1f, c = 0X1.P+3D};
    s [n isin {3}] {a == 1_0.5_0e1_0} / {b = .5e-3F, c = 5.e-1};
    s [n isin {4}] {a == 5.d} / {b = 0x0p0f, c = 0e-999};
    s [n isin {5}] {a == 09.5} / {b = 08f, c = 4.9e-324};
  }
}

//// GoodRealTest.mt
testsuite GoodRealTest for GoodReal {
  test forms {
    input { a: <5., Tk, 0x1p3, Tk, .5, Tk>; n: <0, Tk, 0, Tk, 1, Tk>; }
    expect { b: <5.f, Tk, Tk, 1f, Tk>; c: <8., Tk, Tk, 0.375, Tk>; }
  }
}
