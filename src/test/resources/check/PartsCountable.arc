//// p/Bad.arc
package p;
component Bad {
//        ~~~ error ARC0131: component 'Bad' consists of 111,110 parts, of which 100,000 can be made; leave some out
  component D a, b, c, d, e, f, g, h, i, j;
}

//// p/Worse.arc
package p;
component Worse {
  component Bad a, b, c, d, e, f, g, h, i, j;
}

//// p/Good.arc
package p;
component Good {
  component D a, b, c, d, e, f, g, h, i;
}

//// p/D.arc
package p;
component D {
  component C a, b, c, d, e, f, g, h, i, j;
}

//// p/C.arc
package p;
component C {
  component B a, b, c, d, e, f, g, h, i, j;
}

//// p/B.arc
package p;
component B {
  component A a, b, c, d, e, f, g, h, i, j;
}

//// p/A.arc
package p;
component A {
  component Piece a, b, c, d, e, f, g, h, i, j;
}

//// p/Piece.arc
package p;
component Piece {}
