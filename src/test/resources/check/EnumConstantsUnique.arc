//// robot/BadTypes.cd
package robot;

classdiagram BadTypes {
  enum MotorCmd { fwd, stop, fwd; }
//                           ~~~ error ARC0602: enum 'MotorCmd' lists 'fwd' twice; rename or remove one
}

//// robot/GoodTypes.cd
package robot;

classdiagram GoodTypes {
  enum MotorCmd { fwd, stop, back; }
}
