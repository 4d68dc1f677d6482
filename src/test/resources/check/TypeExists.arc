//// p/Types.cd
package p;
classdiagram Types {
  enum Cmd { fwd, stop; }
  class Cup { Integr volume; }
//            ~~~~~~ error ARC0120: there is no type 'Integr'; did you mean 'Integer'?
  class Mug extends Cap { Cup inner; }
//                  ~~~ error ARC0120: there is no type 'Cap'; define it in a class diagram, or import it
}

//// q/Types.cd
package q;
classdiagram Types {
  enum Cmd { fwd, stop; }
}

//// r/Bad.arc
package r;
import p.Types.*;
import q.Types.*;
import java.util.List;
component Bad<T>(Intger size = 3) {
//               ~~~~~~ error ARC0120: there is no type 'Intger'; did you mean 'Integer'?
  port in Cmd cmd, in Intger power, in Boolean[] many, in List<Integer> list, in Integer<T> odd;
//        ~~~ error ARC0120: 'Cmd' could mean several types; write the full name of one
//                    ~~~~~~ error ARC0120: there is no type 'Intger'; did you mean 'Integer'?
//                                     ~~~~~~~~~ error ARC0120: 'Boolean[]' is no message type; arrays cannot be messages; use one port per element
//                                                        ~~~~~~~~~~~~~ error ARC0120: 'List' is no message type; classes of the Java library cannot be messages; define a class or an enum in a class diagram
//                                                                               ~~~~~~~~~~ error ARC0120: 'Integer<T>' is no message type; only components take type arguments; use the type without them
  port in T t, out Boolean[0..3] bits;
//                        ~~~~~~ error ARC0332: only whole number types have ranges

  Strng name = "Robot";
//~~~~~ error ARC0120: there is no type 'Strng'; did you mean 'String'?

  automaton {
    variable Speed speed;
//           ~~~~~ error ARC0120: there is no type 'Speed'; define it in a class diagram, or import it
    state s;
    initial s;
    s {power == 3} / {speed = 4};
  }
}

//// r/Good.arc
package r;
import p.Types.Cmd;
component Good<T> {
  port in Cmd cmd, in q.Types.Cmd other, in T t, out Integer[0..3] bits;
}

//// s/NotInSight.arc
package s;
component NotInSight {
  port in Mug mug, out Integer volume;
//        ~~~ error ARC0120: type 'Mug' is not in sight of this file; add 'import p.Types.Mug;'
}

//// Clause.arc
component Clause {
  port in Boolean a;
  timimg instant;
//~~~~~~ error ARC0120: there is no type 'timimg'; did you mean 'timing'?
  autoconect port;
//~~~~~~~~~~ error ARC0120: there is no type 'autoconect'; did you mean 'autoconnect'?
}
