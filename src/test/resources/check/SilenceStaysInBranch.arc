//// BadCondition.arc
component BadCondition {
  port in Integer x, in Integer y, in Boolean b, <<total>> in Integer sure, out Integer o, out Integer p;
  var Integer n = 0;

  <<completion = "ignore">> compute {
    n++;
    if (x > 3) o = x;
//      ~~~~~ warning ARC0355: this needs a message on 'x'; without one nothing in this 'compute' is done, and 'n' is left to completion 'ignore' as well; write 'x != -- && x > 3'
    if (x > 3 && y < 2) { p = 1; }
//      ~~~~~~~~~~~~~~ warning ARC0355: this may need a message on 'x' and 'y'; without one nothing in this 'compute' is done, and 'n' is left to completion 'ignore' as well; write 'x != -- && y != -- && x > 3 && y < 2'
    if (b || y > 2 || sure > 4) p = 2;
//      ~~~~~~~~~~~~~~~~~~~~~~ warning ARC0355: this may need a message on 'b' and 'y'; without one nothing in this 'compute' is done, and 'n' is left to completion 'ignore' as well; ask 'b != -- && y != --' before what reads it
    if (x != -- && (b implies y > 2)) p = 3;
//      ~~~~~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC0355: this may need a message on 'b' and 'y'; without one nothing in this 'compute' is done, and 'n' is left to completion 'ignore' as well; ask 'b != -- && y != --' before what reads it
  }
}

//// BadBranch.arc
component BadBranch {
  port <<total>> in Integer mode, in Integer x, in Integer y, out Integer o, out Integer p, out Integer q;
  var Integer n = 0;
  var Integer sum = 0;

  compute {
    Integer twice = 2 * x;
    Integer other = 0;
    n++;
    if (mode == 1) {
      o = x;
//        ~ warning ARC0355: this needs a message on 'x'; without one nothing in this 'compute' is done, and 'n' is left to completion 'chaos' as well; write 'if (x != --)' before it
      sum += 1;
    } else if (mode == 2) {
      o = twice;
//        ~~~~~ warning ARC0355: this needs a message on 'x'; without one nothing in this 'compute' is done, and 'n' is left to completion 'chaos' as well; write 'if (x != --)' before it
      sum += twice + y;
//    ~~~~~~~~~~~~~~~~~ warning ARC0355: this needs a message on 'x' and 'y'; without one nothing in this 'compute' is done, and 'n' is left to completion 'chaos' as well; write 'if (x != -- && y != --)' before it
    } else if (mode == 3) o = y > 3 ? x : 0;
//                            ~~~~~~~~~~~~~ warning ARC0355: this needs a message on 'y' and 'x'; without one nothing in this 'compute' is done, and 'n' is left to completion 'chaos' as well; write '{ if (y != -- && x != --) .. }' around it
    else if (mode == 4) {
      if (x != --) o = x;
      if (x == --) { o = 0; } else { o = twice; }
    } else {
      other = y;
//            ~ warning ARC0355: this needs a message on 'y'; without one nothing in this 'compute' is done, and 'n' is left to completion 'chaos' as well; write 'if (y != --)' before it
      n = x == -- ? 0 : x;
//        ~~~~~~~~~~~~~~~ warning ARC0355: this needs a message on 'x'; without one nothing in this 'compute' is done, and 'n' is left to completion 'chaos' as well; decide by 'if (x != --) .. else ..' what is kept or sent
    }
    p = other + n;
    q = sum;
  }
}

//// BadOneOfTwo.arc
component BadOneOfTwo {
  timing instant;
  port in Integer a, in Integer b, out Boolean high, out Boolean low;

  <<completion = "error">> compute {
    if (a > 3) high = true;
//      ~~~~~ warning ARC0355: this needs a message on 'a'; without one nothing in this 'compute' is done, and 'low' is left to completion 'error' as well; write 'a != -- && a > 3'
    if (b > 3) low = true;
//      ~~~~~ warning ARC0355: this needs a message on 'b'; without one nothing in this 'compute' is done, and 'high' is left to completion 'error' as well; write 'b != -- && b > 3'
  }
}

//// BadElse.arc
component BadElse {
  port in Integer x, out Integer o, out Integer p;
  var Integer n = 0;

  <<completion = "output">> compute {
    n++;
    if (x > 3) {
//      ~~~~~ warning ARC0355: this needs a message on 'x'; without one nothing in this 'compute' is done, and 'n' is left to completion 'output' as well; write 'x != -- && x > 3'
      o = 1;
    } else if (x > 2) {
      o = 2;
    }
    if (x > 7) p = 1; else p = 2;
//      ~~~~~ warning ARC0355: this needs a message on 'x'; without one nothing in this 'compute' is done, and 'n' is left to completion 'output' as well; write 'x != -- && x > 7'
  }
}

//// BadDefault.arc
component BadDefault {
  port in Integer x, out Integer o;

  <<completion = "ignore">> compute {
    o = 0;
    if (x > 3) {
//      ~~~~~ warning ARC0355: this needs a message on 'x'; without one nothing in this 'compute' is done, and 'o' is left to completion 'ignore' as well; write 'x != -- && x > 3'
      o = 1;
    }
  }
}

//// BadArray.arc
component BadArray {
  port in Integer[0..9] key[2], out Integer o;
  var Integer n = 0;

  <<completion = "ignore">> compute {
    n = n + 1;
    if (key[1] > 3) o = 1;
//      ~~~~~~~~~~ warning ARC0355: this needs a message on 'key[1]'; without one nothing in this 'compute' is done, and 'n' is left to completion 'ignore' as well; write 'key[1] != -- && key[1] > 3'
    if (forall k in key: k > 3) o = 2;
//      ~~~~~~~~~~~~~~~~~~~~~~ warning ARC0355: this may need a message on 'key[0]' and 'key[1]'; without one nothing in this 'compute' is done, and 'n' is left to completion 'ignore' as well; write 'key[0] != -- && key[1] != -- && forall k in key: k > 3'
  }
}

//// GoodWaits.arc
component GoodWaits {
  port in Integer x, in Integer y, out Integer o, out Integer p;
  var Integer n = 0;

  <<completion = "ignore">> compute {
    n++;
    o = x + y;
    if (x > 3) p = y;
    if (y > 3) p = x;
  }
}

//// GoodGuarded.arc
component GoodGuarded {
  port in Integer x, in Integer y, in Boolean b, <<total>> in Integer sure, out Integer o, out Integer p;
  var Integer n = 0;

  <<completion = "ignore">> compute {
    Boolean there = x != -- && y != --;
    Integer sum = x + y;
    n++;
    if (there && sum > 3) {
      if (x > 2) o = sum;
      else o = y;
    }
    if (x == --) {
      o = sure;
    } else if (x > sure) {
      o = x;
    }
    if (b != --) {
      if (b) n--;
    }
  }
}

//// GoodAsked.arc
component GoodAsked {
  port in Integer x, in Integer y, in Boolean b, out Integer p;
  var Integer n = 0;

  <<completion = "ignore">> compute {
    n++;
    if (b == -- || !b) p = 1;
    if (y != -- implies y > 3) p = 2;
    if (!(x == --) && x > 5) p = 4;
    if (x == -- || x > 5) p = 5;
    if (x == -- ? true : x > 5) p = 5;
  }
}

//// GoodAllNeedIt.arc
component GoodAllNeedIt {
  port in Integer x, in Integer y, out Integer o, out Integer p;
  var Integer n = 0;

  <<completion = "ignore">> compute {
    Integer twice = 2 * x;
    Integer unused = y;
    if (x > 3) {
      o = 1;
      n++;
    } else if (twice > 5) {
      p = 2;
    }
  }
}

//// GoodOverwritten.arc
component GoodOverwritten {
  port in Integer x, <<total>> in Integer mode, out Integer o, out Integer p;
  var Integer n = 0;

  <<completion = "ignore">> compute {
    n++;
    if (mode == 1) { p = x; }
    p = --;
  }
}

//// GoodApart.arc
component GoodApart {
  port <<total>> in Integer mode, in Integer x, in Integer y, out Integer o;

  <<completion = "ignore">> compute {
    if (mode == 1) {
      o = x;
    } else {
      o = y;
    }
  }
}

//// GoodTransition.arc
component GoodTransition {
  port in Integer x, in Integer y, out Integer o;

  <<completion = "ignore">> automaton {
    variable Integer n = 0;
    state s;
    initial s;
    s {x == ?} / do {
      n = x;
      if (y > 3) o = y;
    };
  }
}
