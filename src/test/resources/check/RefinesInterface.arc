//// robot/v2/BadGuard.arc
package robot.v2;

component BadGuard refines robot.v1.Guard {
//                         ~~~~~~~~~~~~~~ error ARC0402: 'robot.v1.Guard' has a port that 'BadGuard' lacks; declare 'out Boolean drive'
  port in Boolean tooClose, out Boolean motor;
}

//// robot/v1/Guard.arc
package robot.v1;

component Guard {
  port in Boolean tooClose, out Boolean drive;
}

//// robot/v2/GoodGuard.arc
package robot.v2;

component GoodGuard refines robot.v1.Guard {
  port in Boolean tooClose, in Boolean lost, out Boolean drive;
}

//// robot/v2/Guard.arc
package robot.v2;

component Guard refines robot.v1.Guard {
  port in Integer tooClose, in Boolean drive;
//                ~~~~~~~~ error ARC0402: port 'tooClose' is 'in Integer tooClose', but in the refined 'robot.v1.Guard' it is 'in Boolean tooClose'; declare it as there
//                                     ~~~~~ error ARC0402: port 'drive' is 'in Boolean drive', but in the refined 'robot.v1.Guard' it is 'out Boolean drive'; declare it as there
}
