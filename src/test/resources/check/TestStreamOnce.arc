//// robot/BadGuardTest.mt
package robot;

testsuite BadGuardTest for Guard {
  test stops {
    input { tooClose: <true>; tooClose: <false>; }
//                            ~~~~~~~~ error ARC0709: test 'stops' has two streams for 'tooClose'; join them or remove one
    expect { drive: <true, Tk, false>; }
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
