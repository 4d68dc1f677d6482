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

//// r/BadCafé.arc
package r;
component BadCafé {
  port in Boolean i, out Boolean o;
}

//// r/BadCafé.arc
package r;
component BadCafé {
//        ~~~~~~~~ error ARC0213: the files 'r/BadCafé.arc' and 'r/BadCafé.arc' differ in how accents are encoded only; rename one of them
//        ~~~~~~~~ error ARC0214: 'r.BadCafé' is defined twice; rename one
  port in Boolean i, out Boolean o;
}
