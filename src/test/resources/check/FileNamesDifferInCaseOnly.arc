//// p/BadLine.arc
package p;
component BadLine {
  port in Boolean i, out Boolean o;
}

//// p/Badline.arc
package p;
component Badline {
//        ~~~~~~~ error ARC0213: the files 'p/BadLine.arc' and 'p/Badline.arc' differ in upper and lower case only; rename one of them
  port in Boolean i, out Boolean o;
}

//// q/GoodLine.arc
package q;
component GoodLine {
  port in Boolean i, out Boolean o;
}

//// p/GoodLine.arc
package p;
component GoodLine {
  port in Boolean i, out Boolean o;
}
