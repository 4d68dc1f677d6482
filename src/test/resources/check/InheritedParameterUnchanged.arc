//// Motor.arc
component Motor(Integer power, String name = "left") {
  port in Boolean go, out Integer turns;
  automaton {
    state running;
    initial running;
    running {go == true} / {turns = power};
  }
}

//// Bad.arc
component Bad(Double power, Boolean fast) extends Motor {
//                   ~~~~~ error ARC0148: parameter 'power' is inherited as Integer, but declared as Double; give this one another name, or write arguments for 'Motor'
}

//// BadBelow.arc
component BadBelow(Boolean name) extends Good {
//                         ~~~~ error ARC0148: parameter 'name' is inherited as String, but declared as Boolean; give this one another name, or write arguments for 'Good'
}

//// Good.arc
component Good(Integer power = 3, Double ratio = 0.5) extends Motor {
}

//// GoodWithArguments.arc
component GoodWithArguments(Double power, Boolean name = true) extends Motor(3, "right") {
}

//// GoodBelowArguments.arc
component GoodBelowArguments(Double power, Integer name = 1) extends GoodWithArguments(power, true) {
}

//// GoodBeyond.arc
component GoodBeyond(Double power, Boolean name) extends GoodWithArguments {
}

//// Box.arc
component Box<T>(T first) {
  port in T input;
}

//// GoodBox.arc
component GoodBox(String first) extends Box<String> {
}
