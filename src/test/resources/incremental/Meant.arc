//// p/Meant.arc
package p;
<<suppress = "ARC0210: names of 2012">> component Meant {
  port <<suppress = "ARC0210: nothing to suppress">> in Integer distance;
}

//// p/Outer.arc
package p;
component Outer {
  port in Boolean go;
  component Inner {
    port in Boolean go;
  }
  component Inner inner;
  connect go -> inner.go;
}

//// p/OuterInner.arc
package p;
component OuterInner {
  port in Boolean go;
}
