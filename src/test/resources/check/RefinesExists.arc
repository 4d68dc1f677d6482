//// robot/v2/BadGuard.arc
package robot.v2;

component BadGuard refines robot.v1.Gard {
//                         ~~~~~~~~~~~~~ error ARC0401: there is no component 'robot.v1.Gard'; did you mean 'robot.v1.Guard'?
  port in Boolean tooClose, out Boolean drive;

  automaton {
    state driving;
    initial driving / {drive = true};
    driving {tooClose == true} / {drive = false};
  }
}

//// robot/v1/Guard.arc
package robot.v1;

component Guard {
  port in Boolean tooClose, out Boolean drive;
}

//// robot/v2/GoodGuard.arc
package robot.v2;

component GoodGuard refines robot.v1.Guard {
  port in Boolean tooClose, out Boolean drive;

  automaton {
    state driving;
    initial driving / {drive = true};
    driving {tooClose == true} / {drive = false};
  }
}

//// robot/v2/NotItself.arc
package robot.v2;

component NotItself refines NotItselff {
//                          ~~~~~~~~~~ error ARC0401: there is no component 'NotItselff'; correct the name, or add the file to those that are read
  port in Boolean tooClose, out Boolean drive;
}
