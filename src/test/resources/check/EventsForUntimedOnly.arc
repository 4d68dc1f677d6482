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

//// robot/Bell.arc
package robot;

component Bell {
  timing untimed;
  port in Boolean button, out Boolean ring;

  automaton {
    state idle;
    initial idle;
    idle {button == true} / {ring = true};
  }
}

//// robot/SlicedBellTest.mt
package robot;

testsuite SlicedBellTest for Bell {
  test rings {
    events { button: <true, 2*(Tk, true)>; }
//                             ~~ error ARC0707: 'Tk' ends a slice, but an untimed component knows none; leave it out
    expect { ring: <true, Tk, true>; }
//                        ~~ error ARC0707: 'Tk' ends a slice, but an untimed component knows none; leave it out
  }
}
