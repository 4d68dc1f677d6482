//// types/Types.cd
package types;
classdiagram Types {
  enum MotorCmd { fwd, stop; }
  enum Distance { near, far; }
}

//// types/Motor.arc
package types;
import types.Types.MotorCmd;
component Motor {
  port in MotorCmd cmd;
}

//// p/Bad.arc
package p;
import types.Types.MotorCmd;
//~~~~~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC0123: nothing in this file needs 'types.Types.MotorCmd'; delete the import
import types.Types.Distance;
import types.Motor;
//~~~~~~~~~~~~~~~~~~~ warning ARC0123: nothing in this file needs 'types.Motor'; delete the import
component Bad {
  port in Distance distance;
}

//// q/BadAll.arc
package q;
import types.*;
//~~~~~~~~~~~~~~~ warning ARC0123: nothing in this file needs 'types.*'; delete the import
import types.Types.*;
component BadAll {
  port in Distance distance;
}

//// p/Good.arc
package p;
import types.Types.MotorCmd;
import types.Types.Distance;
import types.Motor;
component Good {
  port in MotorCmd cmd, in Boolean go, out Boolean near;
  component Motor motor;
  connect cmd -> motor.cmd;
  component Near nearby {
    port in Boolean go, out Boolean near;
    automaton {
      state s;
      initial s;
      s [Distance.near == Distance.far] / {near = go};
    }
  }
  connect go -> nearby.go;
  connect nearby.near -> near;
}
