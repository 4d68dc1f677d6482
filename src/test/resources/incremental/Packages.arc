//// lonely/Single.arc
package lonely;
component Single {
  port in Boolean go;
}

//// p/Visitor.arc
package p;
import lonely.*;
component Visitor {
  port in Boolean go;
  component Single single;
  connect go -> single.go;
}

//// p/Guest.arc
package p;
import lonely.*;
component Guest {
  port in Boolean go;
}
