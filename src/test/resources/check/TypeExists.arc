//// p/Types.cd
package p;
classdiagram Types {
  enum Cmd { fwd, stop; }
  class Cup { Integr volume; }
//            ~~~~~~ error ARC0120: there is no type 'Integr'; did you mean 'Integer'?
  class Mug extends Cap { Cup inner; }
//                  ~~~ error ARC0120: there is no type 'Cap'; did you mean 'Cup'?
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
  port in Cmd cmd, in Intger power, in Boolen[] many, in List<Integer, T> list, in Integer<T> odd;
//        ~~~ error ARC0120: 'Cmd' could mean several types; write the full name of one
//                    ~~~~~~ error ARC0120: there is no type 'Intger'; did you mean 'Integer'?
//                                     ~~~~~~ error ARC0120: there is no type 'Boolen'; did you mean 'Boolean'?
//                                                       ~~~~~~~~~~~~~~~~ error ARC0120: 'List<Integer, T>' is no message type; java.util.List takes 1 type argument
//                                                                                 ~~~~~~~~~~ error ARC0120: 'Integer<T>' is no message type; only components take type arguments; use the type without them
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

//// j/OfJava.arc
package j;
import java.util.*;
import java.awt.Color;
component OfJava {
  port in List<int> numbers, in Map<String, Lst> map, in Object<String> object, in List<DayOfWeek[]> rows;
//        ~~~~~~~~~ error ARC0120: 'List<int>' is no message type; type arguments are types of objects; write Integer instead of int, without a range
//                                          ~~~ error ARC0120: there is no type 'Lst'; define it in a class diagram, or import it
//                                                       ~~~~~~~~~~~~~~ error ARC0120: 'Object<String>' is no message type; java.lang.Object takes no type arguments
//                                                                                      ~~~~~~~~~ error ARC0120: there is no type 'DayOfWeek'; define it in a class diagram, or import it
  port in java.util.Lists lists, in Color colour, in java.time.DayOfWeek day, in List<Integer[0..3]> small;
//        ~~~~~~~~~~~~~~~ error ARC0120: 'java.util.Lists' is no message type; it is not known here; write 'type Lists;' in a class diagram
//                                  ~~~~~ error ARC0120: 'java.awt.Color' is no message type; it is not known here; write 'type Color;' in a class diagram
//                                                   ~~~~~~~~~~~~~~~~~~~ error ARC0120: 'java.time.DayOfWeek' is no message type; it has few values, which models have to know; define an enum in a class diagram
//                                                                               ~~~~~~~~~~~~~~~~~~~ error ARC0120: 'List<Integer[0..3]>' is no message type; type arguments are types of objects; write Integer instead of int, without a range
  port in Object anything, in Map.Entry<String, ? extends Number> entry, in List raw, in List<?> some;
}

//// k/Unknown.arc
package k;
import java.awt.*;
component Unknown {
  port in Colour colour;
//        ~~~~~~ error ARC0120: there is no type 'Colour'; define it in a class diagram, or import it
}

//// k/Thread.arc
package k;
component Thread {
  port in Boolean on;
}

//// k/Hidden.arc
package k;
component Hidden {
  port in Thread one, in Process two;
//        ~~~~~~ error ARC0120: there is no type 'Thread'; a component is no type of messages
//               ~~~ warning ARC0108: input 'one' leads to no part; connect it
//                       ~~~~~~~ error ARC0120: there is no type 'Process'; define it in a class diagram, or import it
//                               ~~~ warning ARC0108: input 'two' leads to no part; connect it
  component Process {
  }
}

//// n/Kinds.cd
package n;
classdiagram Kinds { type Parcel; }

//// n/Misspelled.arc
package n;
component Misspelled {
  port in Parcell arrived;
//        ~~~~~~~ error ARC0120: there is no type 'Parcell'; did you mean 'Parcel'?
}

//// OtherLanguages.arc
component OtherLanguages {
  port in Bool c, in bool d, in Int e, in integer f, in string g, in Str h, in int64 i, in real j;
//        ~~~~ error ARC0120: there is no type 'Bool'; did you mean 'Boolean'?
//                   ~~~~ error ARC0120: there is no type 'bool'; did you mean 'Boolean'?
//                              ~~~ error ARC0120: there is no type 'Int'; did you mean 'Integer'?
//                                        ~~~~~~~ error ARC0120: there is no type 'integer'; did you mean 'Integer'?
//                                                      ~~~~~~ error ARC0120: there is no type 'string'; did you mean 'String'?
//                                                                   ~~~ error ARC0120: there is no type 'Str'; did you mean 'String'?
//                                                                             ~~~~~ error ARC0120: there is no type 'int64'; did you mean 'Long'?
//                                                                                         ~~~~ error ARC0120: there is no type 'real'; did you mean 'Double'?
}
