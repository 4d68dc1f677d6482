//// robot/BadGuardTest.mt
package robot;

testsuite BadGuardTest for Guard {
  test stops {
    input { tooClose: <2000000*Tk>; }
//          ~~~~~~~~ error ARC0710: the streams of this test have more than 200,000 slices and messages, most of them here; repeat fewer times
    expect { drive: <true, 0*Tk>; }
//                         ~~~~ error ARC0710: this repeats 0 times; repeat at least once, or remove it
  }
}

//// robot/GoodGuardTest.mt
package robot;

testsuite GoodGuardTest for Guard {
  test stops {
    input { tooClose: <2000*Tk>; }
    expect { drive: <true, Tk>; }
  }
}

//// robot/Nested.mt
package robot;

testsuite Nested for Guard {
  test stops {
    input { tooClose: <2000*(1000*Tk)>; }
//          ~~~~~~~~ error ARC0710: the streams of this test have more than 200,000 slices and messages, most of them here; repeat fewer times
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
