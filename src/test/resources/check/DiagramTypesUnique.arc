//// robot/BadTypes.cd
package robot;

classdiagram BadTypes {
  enum Distance { clear, tooClose; }
  class Distance { int millimetres; }
//      ~~~~~~~~ error ARC0601: class diagram 'BadTypes' defines 'Distance' twice; rename or remove one
}

//// robot/GoodTypes.cd
package robot;

classdiagram GoodTypes {
  enum Distance { clear, tooClose; }
  class Measurement { int millimetres; }
}
