//// robot/BadTypes.cd
package robot;

classdiagram BadTypes {
  class Cup { int volume; double volume; }
//                               ~~~~~~ error ARC0603: class 'Cup' has an attribute 'volume' already; rename or remove one
  class BigCup extends Cup { int volume; }
//                               ~~~~~~ error ARC0603: class 'BigCup' has an attribute 'volume' already, inherited from 'Cup'; rename or remove one
}

//// robot/GoodTypes.cd
package robot;

classdiagram GoodTypes {
  class Cup { int volume; }
  class BigCup extends Cup { int weight; }
}
