//// robot/BadTypes.cd
package robot;

classdiagram BadTypes {
  class Node { int value; Node next; }
//                        ~~~~ error ARC0607: class 'Node' would contain itself without end (Node -> Node); remove attribute 'next', or send a number that stands for the other object
  class Cup { int volume; Saucer saucer; }
//                        ~~~~~~ error ARC0607: class 'Cup' would contain itself without end (Cup -> Saucer -> Cup); remove attribute 'saucer', or send a number that stands for the other object
  class Saucer { Cup cup; }
  class Tray { Cup cup; }
}

//// robot/Inherited.cd
package robot;

classdiagram Inherited {
  class Base { Part part; }
//             ~~~~ error ARC0607: class 'Part' would contain itself without end (Part -> Part); remove attribute 'part', or send a number that stands for the other object
  class Part extends Base { int value; }
}

//// robot/GoodTypes.cd
package robot;

classdiagram GoodTypes {
  class Cup { int volume; Saucer saucer; Saucer spare; }
  class Saucer { int width; }
  class Tray { Cup cup; Saucer saucer; }
}
