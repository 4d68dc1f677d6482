//// p/Motor.arc
package p;
component Motor {
  port in Integer power;
}

//// q/Motor.arc
package q;
component Motor {
  port in Integer power;
}

//// q/Types.cd
package q;
classdiagram Types {
  enum Cmd { fwd, stop; }
}

//// r/Bad.arc
package r;
import p.Motor;
import q.Motor;
import q.Types.Cmd;
component Bad extends Base {
//                    ~~~~ error ARC0111: there is no component 'Base'; declare or import it
  port in Integer power;

  component Motor motor;
//          ~~~~~ error ARC0111: 'Motor' could mean several components; write the full name of one
  component Sonar;
//          ~~~~~ error ARC0111: there is no component 'Sonar'; declare or import it
  component Cmd cmd;
//          ~~~ error ARC0111: 'Cmd' is a type of messages; a part needs a component

  component Gauge {
    port in Integer level;
  }
  component Gouge gauge;
//          ~~~~~ error ARC0111: there is no component 'Gouge'; did you mean 'Gauge'?

  connect power -> motor.power, gauge.level;
}

//// r/Good.arc
package r;
component Good {
  port in Integer power;

  component p.Motor left;
  component q.Motor right;

  connect power -> left.power, right.power;
}

//// q/Wheel.arc
package q;
component Wheel {
  port in Integer power;
}

//// s/NotInSight.arc
package s;
component NotInSight {
  port in Integer power;

  component Wheel wheel;
//          ~~~~~ error ARC0111: component 'Wheel' is not in sight of this file; add 'import q.Wheel;'

  connect power -> wheel.power;
}
