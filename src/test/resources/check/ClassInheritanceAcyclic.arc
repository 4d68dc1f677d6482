//// robot/BadTypes.cd
package robot;

classdiagram BadTypes {
  class Cup extends Mug { int volume; }
//                  ~~~ error ARC0604: class 'Cup' inherits from itself (Cup -> Mug -> Cup); remove one 'extends'
  class Mug extends Cup { int weight; }
}

//// robot/GoodTypes.cd
package robot;

classdiagram GoodTypes {
  class Cup { int volume; }
  class Mug extends Cup { int weight; }
}

//// robot/Alone.cd
package robot;

classdiagram Alone {
  class Cup extends Cup { int volume; }
//                  ~~~ error ARC0604: class 'Cup' inherits from itself (Cup -> Cup); remove one 'extends'
}
