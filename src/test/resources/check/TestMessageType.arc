//// robot/BadGuardTest.mt
package robot;

testsuite BadGuardTest for Guard {
  test stops {
    input { tooClose: <true, Tk, 3>; }
//                               ~ error ARC0703: port 'tooClose' takes Boolean, but '3' is of type Integer
    expect { drive: <true, Tk, "no">; }
//                             ~~~~ error ARC0703: port 'drive' takes Boolean, but '"no"' is of type String
  }
}

//// robot/GoodGuardTest.mt
package robot;

testsuite GoodGuardTest for Guard {
  test stops {
    input { tooClose: <true, Tk, false>; }
    expect { drive: <true, Tk, false>; }
  }
}

//// robot/Guard.arc
package robot;

component Guard {
  port in Boolean tooClose, out Boolean drive;

  automaton {
    state driving;
    initial driving / {drive = true};
    driving {tooClose == true} / {drive = false};
  }
}
