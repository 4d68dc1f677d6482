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
