//// robot/BadTypes.cd
package robot;

classdiagram BadTypes {
  enum Size { small, big; }
  class Cup extends Size { int volume; }
//                  ~~~~ error ARC0606: class 'Cup' cannot extend 'Size', which is no class; make it an attribute
}

//// robot/GoodTypes.cd
package robot;

classdiagram GoodTypes {
  enum Size { small, big; }
  class Cup { Size size; int volume; }
}
