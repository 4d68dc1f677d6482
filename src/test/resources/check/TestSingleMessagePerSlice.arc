//// robot/BadGuardTest.mt
package robot;

testsuite BadGuardTest for Guard {
  test stops {
    input { tooClose: <true, false, Tk>; }
//                           ~~~~~ error ARC0706: this slice of 'tooClose' has a message already; write 'Tk' between two messages
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

//// robot/Repeated.mt
package robot;

testsuite Repeated for Guard {
  test stops {
    input { tooClose: <3*true, Tk>; }
//                       ~~~~ error ARC0706: this slice of 'tooClose' has a message already; write 'Tk' between two messages
    expect { drive: <true, Tk, 2*(false)>; }
//                                ~~~~~ error ARC0706: this slice of 'drive' has a message already; write 'Tk' between two messages
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
