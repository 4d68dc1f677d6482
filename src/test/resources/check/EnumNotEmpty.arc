//// robot/BadTypes.cd
package robot;

classdiagram BadTypes {
  enum Distance { }
//     ~~~~~~~~ error ARC0605: enum 'Distance' has no constants, so a port of this type could never carry a message; list its constants
}

//// robot/GoodTypes.cd
package robot;

classdiagram GoodTypes {
  enum Distance { clear, tooClose; }
}
