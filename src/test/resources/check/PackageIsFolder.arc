//// robots/coffee/BadFetcher.arc
package coffee.robots;
//      ~~~~~~~~~~~~~ error ARC0208: package 'coffee.robots' belongs in the folder 'coffee/robots', but the file lies in 'robots/coffee'; move the file or change the package
component BadFetcher {
  port in Boolean i, out Boolean o;
}

//// coffee/GoodFetcher.arc
package coffee;
component GoodFetcher {
  port in Boolean i, out Boolean o;
}

//// models/src/coffee/robots/GoodDeep.arc
package coffee.robots;
component GoodDeep {
  port in Boolean i, out Boolean o;
}

//// ../GoodUnknown.arc
package coffee.robots;
component GoodUnknown {
  port in Boolean i, out Boolean o;
}
