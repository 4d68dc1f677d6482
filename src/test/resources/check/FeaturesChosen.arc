//// Lamp.arc
component Lamp(Integer step = 1) {
  feature dimmer, alarm;
  constraint (alarm implies dimmer);

  port in Boolean press;

  component Switch {
    port in Boolean on;
  }

  connect press -> switch.on;

  varif (dimmer) {
    port in Integer level;
//                  ~~~~~ warning ARC0108: input 'level' leads to no part; connect it (in Lamp(dimmer = true, alarm = true) and 1 other)
  }
}

//// House.arc
component House(Boolean large) {
  port in Boolean press;

  component Lamp one;
//          ~~~~ error ARC0152: choose 'dimmer', 'alarm' of 'Lamp': write dimmer = true, alarm = true, or false in parentheses behind it
  component Lamp(2, alarm = false) two;
//          ~~~~ error ARC0152: choose 'dimmer' of 'Lamp': write dimmer = true, or false in parentheses behind it
  component Lamp(dimmer = large, alarm = false) three;
//                        ~~~~~ error ARC0152: a feature is chosen by true, by false, or by features of the component around it
  component Lamp(dimmer = false, alarm = true) four;
//          ~~~~ error ARC0152: (dimmer = false, alarm = true) breaks a constraint of 'Lamp'; choose others
  component Lamp(dimmer = false, alarm = false, dimmer = true) five;
//                                              ~~~~~~~~~~~~~ error ARC0152: feature 'dimmer' is chosen already; delete one
  component Lamp(dimmer = false, alarm = false, step = 4) six;
  component Lamp.Switch seven;
//          ~~~~~~~~~~~ error ARC0152: 'Switch' lies in a component with features and is another one in each of its configurations; define it in a file of its own

  connect press -> one.press, two.press, three.press, four.press, five.press, six.press, seven.on;
}

//// Street.arc
component Street {
  feature lit, rich;

  port in Boolean press, in Integer level;
//                                  ~~~~~ warning ARC0108: input 'level' leads to no part; connect it (in Street(lit = true, rich = false) and 1 other)

  component Lamp(dimmer = lit && rich, alarm = rich) lamp;
//          ~~~~ error ARC0152: (dimmer = false, alarm = true) breaks a constraint of 'Lamp'; choose others (in Street(lit = false, rich = true))

  connect press -> lamp.press;

  varif (lit && rich) {
    connect level -> lamp.level;
  }
}

//// Heir.arc
component Heir extends Lamp {
//                     ~~~~ error ARC0152: choose 'dimmer', 'alarm' of 'Lamp': write dimmer = true, alarm = true, or false in parentheses behind it
}

//// GoodHeir.arc
component GoodHeir extends Lamp(dimmer = true, alarm = false) {
}

//// Refiner.arc
component Refiner refines Lamp {
//                        ~~~~ error ARC0152: choose 'dimmer', 'alarm' of 'Lamp': write dimmer = true, alarm = true, or false in parentheses behind it
  port in Boolean press, in Integer level;
}

//// GoodRefiner.arc
component GoodRefiner refines Lamp(dimmer = rich, alarm = false), Plain {
  feature rich;
  port in Boolean press;
  varif (rich) {
    port in Integer level;
  }
}

//// Plain.arc
component Plain(Integer step = 1) {
  port in Boolean press;
}

//// BadRefiner.arc
component BadRefiner refines Lamp(dimmer = rich, alarm = true), Plain(3) {
//                           ~~~~ error ARC0152: (dimmer = false, alarm = true) breaks a constraint of 'Lamp'; choose others (in BadRefiner(rich = false))
//                                                                    ~ error ARC0152: behind 'refines' arguments choose features, and this chooses none of 'Plain'; delete it
  feature rich;
  port in Boolean press, in Integer level;
}

//// LampTest.mt
testsuite LampTest for Lamp(dimmer = true) {
//                     ~~~~ error ARC0152: choose 'alarm' of 'Lamp': write alarm = true, or false in parentheses behind it
  test nothing { }
}

//// GoodTest.mt
testsuite GoodTest for Lamp(dimmer = true, alarm = true) {
  test nothing { input { level: <1>; } }
}
