//// robot/BadGuardTest.mt
package robot;

testsuite BadGuardTest for Guard {
  int slices;
//~~~~~~~~~~~ warning ARC0708: fields of test suites are not used; give the tested component its values as arguments, as in 'for Guard(3)'

  test stops {
    input { tooClose: <true>; }
  }
}

//// robot/GoodGuardTest.mt
package robot;

testsuite GoodGuardTest for Guard {
  test stops {
    input { tooClose: <true>; }
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
