//// p/Bad.arc
package p;
component Bad(Integer speed) {
  port in Integer speed, in Integer, in Boolean alarm, in Boolean alarm;
//                ~~~~~ error ARC0201: component 'Bad' has a parameter 'speed' already; rename this port
//                                                                ~~~~~ error ARC0201: component 'Bad' has a port 'alarm' already; rename this port

  Integer integer = 3, step = 1;
//        ~~~~~~~ error ARC0201: component 'Bad' has a port 'integer' already; rename this variable

  component Motor {
    port in Integer speed, in Integer step, in Boolean alarm;
  }
  component Motor step;
//                ~~~~ error ARC0201: component 'Bad' has a variable 'step' already; rename this part
  component Motor left, left;
//                      ~~~~ error ARC0201: component 'Bad' has a part 'left' already; rename this part

  connect speed -> left.speed, step.speed;
  connect integer -> left.step, step.step;
  connect alarm -> left.alarm, step.alarm;
}

//// p/BadImplicit.arc
package p;
component BadImplicit {
  port in Integer motor;

  component Motor {
//          ~~~~~ error ARC0201: component 'BadImplicit' has a port 'motor' already; give this part a name, or it is named after its type
    port in Integer step;
  }

  connect motor -> motor.step;
}

//// p/BadInAndOut.arc
package p;
component BadInAndOut {
  port in Integer go, out Integer go;
//                                ~~ error ARC0201: component 'BadInAndOut' has a port 'go' already; rename this port

  component Gate gate {
    timing instant;
    port in Integer go, out Integer go;
//                                  ~~ error ARC0201: component 'Gate' has a port 'go' already; rename this port
  }

  connect go -> gate.go;
}

//// p/Base.arc
package p;
component Base {
  port in Boolean go;
}

//// p/BadHeir.arc
package p;
component BadHeir extends Base {
  Boolean go = true;
//        ~~ error ARC0201: component 'BadHeir' has a port 'go' already; rename this variable
}

//// p/Good.arc
package p;
component Good(Integer speed) {
  port in Integer, in Integer go;

  component Motor {
    port in Integer speed;
  }
  component Motor left, right;

  connect integer -> left.speed;
  connect go -> right.speed;
}
