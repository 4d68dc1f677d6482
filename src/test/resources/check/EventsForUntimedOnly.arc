//// robot/BadGuardTest.mt
package robot;

testsuite BadGuardTest for Guard {
  test stops {
    events { tooClose: true; }
//  ~~~~~~ error ARC0707: component 'Guard' works slice by slice; drive it with an 'input' block
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
