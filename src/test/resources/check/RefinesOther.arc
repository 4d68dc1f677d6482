//// robot/v2/BadGuard.arc
package robot.v2;

component BadGuard refines BadGuard {
//                         ~~~~~~~~ error ARC0403: component 'BadGuard' refines itself; name the other version with its package
  port in Boolean tooClose, out Boolean drive;
}

//// robot/v2/GoodGuard.arc
package robot.v2;

component GoodGuard refines robot.v1.Guard {
  port in Boolean tooClose, out Boolean drive;
}

//// robot/v1/Guard.arc
package robot.v1;

component Guard {
  port in Boolean tooClose, out Boolean drive;
}
