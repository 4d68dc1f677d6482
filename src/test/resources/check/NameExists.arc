//// BadLimit.arc
component BadLimit {
  port in Integer speed, out Integer cmd;

  automaton {
    state running;
    initial running;
    running {speed == ?} / {cmd = sped + 1};
//                                ~~~~ error ARC0329: 'sped' is not a port, a variable or a parameter; did you mean 'speed'?
  }
}

//// GoodLimit.arc
component GoodLimit {
  port in Integer speed, out Integer cmd;

  automaton {
    state running;
    initial running;
    running {speed == ?} / {cmd = speed + 1};
  }
}

//// InGuard.arc
component InGuard {
  port in Integer speed, out Integer cmd;

  automaton {
    state running;
    initial running;
    running [speed > limit] {speed == ?} / {cmd = 1};
//                   ~~~~~ error ARC0329: 'limit' is not a port, a variable or a parameter; declare it or correct the name
  }
}

//// robot/Types.cd
package robot;

classdiagram Types {
  enum Distance { clear, tooClose; }
}

//// robot/Constant.arc
package robot;

import robot.Types.Distance;

component Constant {
  port in Distance front, out Boolean drive;

  automaton {
    state driving;
    initial driving;
    driving {front == Distance.toClose} / {drive = false};
//                             ~~~~~~~ error ARC0329: Distance has no constant 'toClose'; did you mean 'tooClose'?
  }
}

//// robot/NoEcho.arc
package robot;

import robot.Types.Distance;

component NoEcho {
  port in Distance front, out Boolean drive;

  automaton {
    state driving;
    initial driving;
    driving {front == far} / {drive = false};
//                    ~~~ error ARC0329: 'far' is not a port, a variable, a parameter or a constant of Distance; it has clear, tooClose
    driving {fromt == near} / {drive = false};
//           ~~~~~ error ARC0305: there is no input port or variable 'fromt'; did you mean 'front'?
  }
}

//// robot/NoEchoTest.mt
package robot;

testsuite NoEchoTest for NoEcho {
  test a {
    input { front: <far, Tk, Cup(3)>; }
//                  ~~~ error ARC0329: 'far' is not a constant of Distance; it has clear, tooClose
//                           ~~~~~~ error ARC0329: there is no class 'Cup' here; import it or correct the name
  }
}

//// robot/Heir.arc
package robot;

import robot.Types.Distance;

component Heir extends Missing {
//                     ~~~~~~~ error ARC0111: there is no component 'Missing'; declare or import it
  port in Distance near, out Boolean drive;

  automaton {
    state driving;
    initial driving;
    driving [seen > 2 && Distance.toClose == near] {heard == 1} / {drive = told};
//                                ~~~~~~~ error ARC0329: Distance has no constant 'toClose'; did you mean 'tooClose'?
  }
}

//// Truths.arc
component Truths {
  port in Boolean b, out Boolean c;

  automaton {
    state s;
    initial s;
    s [FALSE] {b == True} / {c = flase};
//     ~~~~~ error ARC0329: 'FALSE' is not a port, a variable or a parameter; did you mean 'false'?
//                  ~~~~ error ARC0329: 'True' is not a port, a variable or a parameter; did you mean 'true'?
//                               ~~~~~ error ARC0329: 'flase' is not a port, a variable or a parameter; did you mean 'false'?
  }
}
