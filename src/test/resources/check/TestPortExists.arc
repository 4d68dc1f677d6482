//// robot/BadGuardTest.mt
package robot;

testsuite BadGuardTest for Guard {
  test stops {
    input { toClose: <true>; }
//          ~~~~~~~ error ARC0702: component 'Guard' has no input port 'toClose'; did you mean 'tooClose'?
    expect { tooClose: <true>; }
//           ~~~~~~~~ error ARC0702: the component receives on 'tooClose'; move the stream to the 'input' block
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
