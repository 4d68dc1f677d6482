//// p/Oldest.arc
package p;
component Oldest {
  port in Boolean first, out Integer last;
}

//// p/Middle.arc
package p;
component Middle extends Oldest {
  port in Integer more;
}

//// p/Youngest.arc
package p;
component Youngest extends Middle {
  port in Boolean own;
}

//// q/Owner.arc
package q;
import p.*;
component Owner {
  port in Boolean start, in Integer more, out Integer end;
  component Youngest child;
  connect start -> child.first;
  connect start -> child.own;
  connect more -> child.more;
  connect child.last -> end;
}
