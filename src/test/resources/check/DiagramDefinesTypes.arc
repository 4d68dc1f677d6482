//// robot/BadOld.cd
package robot;

classdiagram BadOld {
  public enum Size { small, big; }
//~~~~~~ warning ARC0609: enum 'Size' says more than a type of messages can mean: 'public'; delete it, or suppress this finding if another tool needs it
  enum Colour { red(1), green(2); int code; int code(); }
//                 ~~~ warning ARC0609: enum 'Colour' says more than a type of messages can mean: the values of 'red', the values of 'green', attribute 'code', method 'code'; delete it, or suppress this finding if another tool needs it
  abstract class Cup extends Vessel implements Drinkable { private int volume = 3; void fill(int volume) { } }
//~~~~~~~~ warning ARC0609: class 'Cup' says more than a type of messages can mean: 'abstract', interface 'Drinkable', 'private', the value of 'volume', and 1 more; delete it, or suppress this finding if another tool needs it
  class Vessel { - int weight; # int a; + int b; / int c; static int d; }
//               ~ warning ARC0609: class 'Vessel' says more than a type of messages can mean: '-', '#', '+', '/', and 1 more; delete it, or suppress this finding if another tool needs it
  interface Drinkable { void drink(); }
//                      ~~~~~~~~~~~~~ warning ARC0609: interface 'Drinkable' says more than a type of messages can mean: method 'drink'; delete it, or suppress this finding if another tool needs it
  association Cup -> (liquid) Liquid [*];
//~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC0609: this association means nothing here, as objects hold nothing but their attributes; write an attribute for what 'Cup' holds, or suppress this finding if another tool needs it
  composition fills [1] Liquid (one) <-> (other) [[volume]] Cup [0..1];
//~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC0609: composition 'fills' means nothing here, as objects hold nothing but their attributes; write an attribute for what 'Liquid' holds, or suppress this finding if another tool needs it
  class Liquid { }
}

//// robot/BadEnd.cd
package robot;

classdiagram BadEnd {
  class Cup { int volume; }
  association Cup -- Saucer;
//~~~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC0609: this association means nothing here, as objects hold nothing but their attributes; write an attribute for what 'Cup' holds, or suppress this finding if another tool needs it
//                   ~~~~~~ error ARC0120: there is no type 'Saucer'; define it in a class diagram, or import it
  class Mug implements Nothing { }
//                     ~~~~~~~ warning ARC0609: class 'Mug' says more than a type of messages can mean: interface 'Nothing'; delete it, or suppress this finding if another tool needs it
}

//// robot/GoodTypes.cd
package robot;

<<suppress = "ARC0609: read by the generator of the shop, too">> classdiagram GoodTypes {
  enum Size { small, big; }
  class Vessel { Size size; }
  class Cup extends Vessel { <<suppress = "ARC0609: kept">> int volume = 2; }
  type Drink;
  interface Drinkable;
  association Cup -> Drink;
}
