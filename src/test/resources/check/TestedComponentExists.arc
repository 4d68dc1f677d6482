//// robot/BadGuardTest.mt
package robot;

testsuite BadGuardTest for Gard {
//                         ~~~~ error ARC0701: there is no component 'Gard'; did you mean 'Guard'?
  test stops {
    input { tooClose: <true>; }
    expect { drive: <true, Tk, false>; }
  }
}

//// robot/GoodGuardTest.mt
package robot;

testsuite GoodGuardTest for Guard {
  test stops {
    input { tooClose: <true>; }
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
