//// types/Types.cd
package types;
classdiagram Types {
  enum MotorCmd { fwd, stop; }
}

//// p/Bad.arc
package p;
import types.Types.MoterCmd;
//     ~~~~~~~~~~~~~~~~~~~~ error ARC0121: there is no component or type 'types.Types.MoterCmd'; did you mean 'types.Types.MotorCmd'?
import types.Tipes.*;
//     ~~~~~~~~~~~ error ARC0121: there is no package, class diagram or component 'types.Tipes'; did you mean 'types.Types'?
import sensors.*;
//     ~~~~~~~ error ARC0121: there is no package, class diagram or component 'sensors'; correct or delete the import
import sensors.Sonar;
//     ~~~~~~~~~~~~~ error ARC0121: there is no component or type 'sensors.Sonar'; correct or delete the import, or write 'type Sonar;' in a class diagram of package 'sensors' if it is a class of Java
component Bad {
  port in MoterCmd cmd, in Distance distance;
  component Sonar sonar;
}

//// p/Good.arc
package p;
import types.Types.MotorCmd;
component Good {
  port in MotorCmd cmd;
}

//// p/GoodWithoutDiagram.arc
package p;
import types.MotorCmd;
component GoodWithoutDiagram {
  port in MotorCmd cmd;
}
