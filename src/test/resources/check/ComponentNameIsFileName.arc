//// Bad.arc
component Fetcher {
//        ~~~~~~~ error ARC0207: 'Fetcher' stands in the file 'Bad.arc'; rename the file to 'Fetcher.arc' or this to 'Bad'
  port in Boolean i, out Boolean o;
}

//// p/badCase.arc
package p;
component BadCase {
//        ~~~~~~~ error ARC0207
  port in Boolean i, out Boolean o;
}

//// Types.cd
classdiagram Messages {
//           ~~~~~~~~ error ARC0207: 'Messages' stands in the file 'Types.cd'; rename the file to 'Messages.cd' or this to 'Types'
  enum Signal { alert; }
}

//// p/Good.arc
package p;
component Good {
  port in Boolean i, out Boolean o;
}

//// café/GoodCafé.arc
/** The file is written apart, the name together. */
package café;
component GoodCafé {
  port in Boolean crème, out Boolean o;

  automaton {
    state s;
    initial s;
    s {crème == true} / {o = true};
  }
}

//// café/GoodBakery.arc
package café;
component GoodBakery {
  component GoodCafé café;
  port in Boolean a, out Boolean b;
  connect a -> café.crème;
  connect café.o -> b;
}
