//// p/Part.arc
package p;
component Part {
  port in Boolean tick, out Integer count;
}

//// p/Bad.arc
package p;
component Bad {
  port in Boolean tick, out Integer count;

  Part part;
//~~~~ error ARC0142: 'Part' is a component: an instance needs the keyword 'component'
  var Part other, third;
//    ~~~~ error ARC0142: 'Part' is a component: an instance needs the keyword 'component'

  connect tick -> part.tick, other.tick;
  connect part.count -> count;
}

//// p/BadInner.arc
package p;
component BadInner {
  component Inner {
    port in Boolean tick;
  }
  Inner inner = 3;
//~~~~~ error ARC0142: 'Inner' is a component: an instance needs the keyword 'component'
}

//// p/Types.cd
package p;
classdiagram Types {
  enum Both { one, two; }
}

//// p/Both.arc
package p;
component Both {
  port in Boolean tick;
}

//// p/GoodType.arc
package p;
import p.Types.Both;
component GoodType {
  Both both = Both.one;
}

//// p/Good.arc
package p;
component Good {
  port in Boolean tick, out Integer count;

  component Part part;

  connect tick -> part.tick;
  connect part.count -> count;
}
