//// BadLimit.arc
component BadLimit {
  port in Integer[0..9] speed, out Integer[0..3] cmd;

  automaton {
    state running;
    initial running;
    running {speed == 9} / {cmd = 4};
//                                ~ error ARC0322: 4 lies outside of Integer[0..3]; write a number from 0 to 3 or widen the range
  }
}

//// GoodLimit.arc
component GoodLimit {
  port in Integer[0..9] speed, out Integer[0..3] cmd;

  automaton {
    state running;
    initial running;
    running {speed == 9} / {cmd = 3};
  }
}

//// Everywhere.arc
component Everywhere {
  port in Integer[0..9] speed, out Integer cmd;

  automaton {
    variable Integer[-2..2] last = -3;
//                                 ~~ error ARC0322: -3 lies outside of Integer[-2..2]; write a number from -2 to 2 or widen the range
    state running;
    initial running;
    running {speed == alt {1, 10}} / {cmd = 4, last = -2};
//                            ~~ error ARC0322: 10 lies outside of Integer[0..9]; write a number from 0 to 9 or widen the range
  }
}

//// Sum.arc
component Sum {
  port in Boolean go, out Integer[0..9] digit;

  automaton {
    state only;
    initial only;
    only {go == true} / {digit = 5 + 5};
//                               ~~~~~ error ARC0322: 10 lies outside of Integer[0..9]; write a number from 0 to 9 or widen the range
    only {go == false} / {digit = 5 + 4};
  }
}

//// Wrapping.arc
/** What is computed has the bits of its operands. */
component Wrapping {
  port in Boolean go, out Integer[0..9] digit, out Long[0..9] big;

  automaton {
    state only;
    initial only;
    only {go == true} / {digit = 2147483647 + 2147483647 + 4, big = 4294967296L * 4294967296L};
    only {go == false} / {digit = 2147483647 + 1};
//                                ~~~~~~~~~~~~~~ error ARC0322: -2147483648 lies outside of Integer[0..9]; write a number from 0 to 9 or widen the range
    only {go == --} / {digit = -(-2147483647 - 1), big = 2147483647L + 1L};
//                             ~~~~~~~~~~~~~~~~~~ error ARC0322: -2147483648 lies outside of Integer[0..9]; write a number from 0 to 9 or widen the range
//                                                       ~~~~~~~~~~~~~~~~ error ARC0322: 2147483648 lies outside of Long[0..9]; write a number from 0 to 9 or widen the range
  }
}

//// Spoken.arc
component Spoken {
  port in Integer[0..9] digit, out Boolean heard;

  automaton {
    state only;
    initial only;
    only {digit == ?} / {heard = true};
  }
}

//// SpokenTest.mt
testsuite SpokenTest for Spoken {
  test hears {
    input { digit: <9, Tk, 10, Tk, 2*(-1, Tk)>; }
//                         ~~ error ARC0322: 10 lies outside of Integer[0..9]; write a number from 0 to 9 or widen the range
//                                    ~~ error ARC0322: -1 lies outside of Integer[0..9]; write a number from 0 to 9 or widen the range
    expect { heard: <Tk, true, Tk, Tk, Tk>; }
  }
}

//// Sized.arc
component Sized(Integer[1..5] size) {
  port in Integer[0..9] speed, out Integer[0..3] cmd;

  automaton {
    state running;
    initial running;
    running {speed == ?} / {cmd = 3};
  }
}

//// BadSizedTest.mt
testsuite BadSizedTest for Sized(6) {
//                               ~ error ARC0322: 6 lies outside of Integer[1..5]; write a number from 1 to 5 or widen the range
  test limits {
    input { speed: <9, Tk, 10>; }
//                         ~~ error ARC0322: 10 lies outside of Integer[0..9]; write a number from 0 to 9 or widen the range
    expect { cmd: <Tk, 3, Tk, -1>; }
//                            ~~ error ARC0322: -1 lies outside of Integer[0..3]; write a number from 0 to 3 or widen the range
  }
}

//// GoodSizedTest.mt
testsuite GoodSizedTest for Sized(5) {
  test limits {
    input { speed: <9, Tk, 0>; }
    expect { cmd: <Tk, 3, Tk, 0>; }
  }
}
