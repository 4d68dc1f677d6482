//// p/Bad.arc
package p;
component Bad {
  component Arm arm;
//              ~~~ error ARC0112: component 'Bad' is a part of itself: Bad -> Arm -> Hand -> Bad; replace one of these parts
}

//// p/Arm.arc
package p;
component Arm {
  component Hand left;
  component Hand right;
}

//// p/Hand.arc
package p;
component Hand {
  component Bad robot;
}

//// p/Self.arc
package p;
component Self {
  component Self self;
//               ~~~~ error ARC0112: component 'Self' is a part of itself: Self -> Self; replace one of these parts
}

//// p/Good.arc
package p;
component Good {
  port in Boolean go;

  component Finger finger;

  component Finger {
    port in Boolean go;
  }

  connect go -> finger.go;
}
