//// types/Types.cd
package types;
classdiagram Types {
  enum MotorCmd { fwd, stop; }
  enum Distance { near, far; }
}

//// p/BadStop.arc
package p;
import types.Types.MotorCmd;
import types.Types.Distance;
  import types.Types.MotorCmd;
//~~~~~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC0122: 'types.Types.MotorCmd' is imported twice; delete this import
component BadStop {
  port in Distance front, out MotorCmd cmd;
}

//// q/BadAll.arc
package q;
import types.Types.*;  import types.Types.*;
//                     ~~~~~~~~~~~~~~~~~~~~~ warning ARC0122
component BadAll {
  port in Distance front, out MotorCmd cmd;
}

//// q/GoodAll.arc
package q;
import types.Types.*;
component GoodAll {
  port in Distance front, out MotorCmd cmd;
}

//// p/GoodStop.arc
package p;
import types.Types.MotorCmd;
import types.Types.Distance;
component GoodStop {
  port in Distance front, out MotorCmd cmd;
}
