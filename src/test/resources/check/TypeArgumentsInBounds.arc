//// p/Types.cd
package p;
classdiagram Types {
  class Cup { Integer volume; }
  class Mug extends Cup { Boolean handle; }
  class Plate { Integer size; }
}

//// p/Bad.arc
package p;
import p.Types.*;
component Bad {
  port in Plate plate;

  component Washer<T extends Cup> {
    port in T i;
  }

  component Washer<Plate> washer;
//                 ~~~~~ error ARC0116: type argument 'Plate' is outside the bound of 'T extends Cup'; use a type that fits it

  connect plate -> washer.i;
}

//// p/Good.arc
package p;
import p.Types.*;
component Good<U extends Mug> {
  port in Mug mug, in U other;

  component Washer<T extends Cup> {
    port in T i;
  }

  component Washer<Mug> washer;
  component Washer<U> second;

  connect mug -> washer.i;
  connect other -> second.i;
}

//// p/OfJava.arc
package p;
import java.util.List;
component OfJava {
  port in Integer number, in String text, in List<String> list;

  component Adder<T extends Number> {
    port in T i;
  }

  component Sorter<T extends Comparable<T>> {
    port in T i;
  }

  component Keeper<T extends List<String>> {
    port in T i;
  }

  component Adder<Integer> one;
  component Adder<String> two;
//                ~~~~~~ error ARC0116: type argument 'String' is outside the bound of 'T extends Number'; use a type that fits it
  component Sorter<String> three;
  component Keeper<List<String>> four;
  component Keeper<Integer> five;
//                 ~~~~~~~ error ARC0116: type argument 'Integer' is outside the bound of 'T extends List<String>'; use a type that fits it

  connect number -> one.i, five.i;
  connect text -> two.i, three.i;
  connect list -> four.i;
}
