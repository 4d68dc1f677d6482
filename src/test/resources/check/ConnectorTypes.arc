//// types/Types.cd
package types;
classdiagram Types {
  enum Cmd { fwd, stop; }
  enum Signal { fwd, stop; }
  class Cup { Integer volume; }
  class Mug extends Cup { Boolean handle; }
}

//// p/Bad.arc
package p;
import types.Types.*;
component Bad {
  port in Boolean go, in Cmd cmd, in Long distance, in Integer wide, in Cup cup;

  component Motor motor {
    port in Integer power, in Signal signal, in Integer speed, in Integer[0..9] level, in Mug mug;
  }

  component Buffer<Double> doubles;
  component Buffer<T> {
    port in T i;
  }

  connect go -> motor.power;
//              ~~~~~~~~~~~ error ARC0106: 'go' sends Boolean, but 'motor.power' receives Integer; make the types equal, or put a component in between
  connect cmd -> motor.signal;
//               ~~~~~~~~~~~~ error ARC0106: 'cmd' sends Cmd, but 'motor.signal' receives Signal; make the types equal, or put a component in between
  connect distance -> motor.speed;
//                    ~~~~~~~~~~~ error ARC0106: 'distance' sends Long, but 'motor.speed' receives Integer; make the types equal, or put a component in between
  connect wide -> motor.level;
//                ~~~~~~~~~~~ error ARC0106: 'wide' sends Integer, but 'motor.level' receives Integer[0..9]; make the types equal, or put a component in between
  connect cup -> motor.mug;
//               ~~~~~~~~~ error ARC0106: 'cup' sends Cup, but 'motor.mug' receives Mug; make the types equal, or put a component in between
  connect go -> doubles.i;
//              ~~~~~~~~~ error ARC0106: 'go' sends Boolean, but 'doubles.i' receives Double; make the types equal, or put a component in between
}

//// p/Good.arc
package p;
import types.Types.*;
component Good {
  port in Cmd cmd, in int small, in Integer[0..9] level, in Mug mug;

  component Motor motor {
    port in Cmd cmd, in Integer distance, in Integer[-1..9] level, in Mug mug;
  }

  component Buffer<Integer> numbers;
  component Buffer<T> {
    port in T i;
  }

  connect cmd -> motor.cmd;
  connect small -> motor.distance, numbers.i;
  connect level -> motor.level;
  connect mug -> motor.mug;
}

//// OfJava.arc
import java.util.*;
component OfJava {
  port in List<String> texts, in List<Integer> numbers, in Object any, out List<Map<String, Integer>> maps;

  component Generic<K, V> {
    port in List<K> one, in List<K> two, in K three, out List<Map<K, V>> four;
  }

  component Generic<String, Integer> part;

  connect texts -> part.one;
  connect numbers -> part.two;
//                   ~~~~~~~~ error ARC0106: 'numbers' sends List<Integer>, but 'part.two' receives List<String>; make the types equal, or put a component in between
  connect any -> part.three;
//               ~~~~~~~~~~ error ARC0106: 'any' sends Object, but 'part.three' receives String; make the types equal, or put a component in between
  connect part.four -> maps;
}
