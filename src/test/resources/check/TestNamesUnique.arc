//// robot/BadGuardTest.mt
package robot;

testsuite BadGuardTest for Guard {
  test stops {
    input { tooClose: <true>; }
  }
  test stops {
//     ~~~~~ error ARC0704: suite 'BadGuardTest' has two tests named 'stops'; rename one
    input { tooClose: <false>; }
  }
}

//// robot/GoodGuardTest.mt
package robot;

testsuite GoodGuardTest for Guard {
  test stops {
    input { tooClose: <true>; }
  }
  test drives {
    input { tooClose: <false>; }
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
