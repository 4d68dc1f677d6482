//// Bad.arc
component Bad {
  port in Integer slow, in Integer fast;
  port out Integer turns;

  component Motor motor {
    port in Integer power, out Integer turns;
  }

  component Motor spare [turns -> turns];
//                                ~~~~~ error ARC0104: port 'turns' has 'motor.turns' as its sender already; a port has one sender only

  connect slow -> motor.power, spare.power;
  connect fast -> motor.power;
//                ~~~~~~~~~~~ error ARC0104: port 'motor.power' has 'slow' as its sender already; a port has one sender only
  connect motor.turns -> turns;
}

//// BadTwice.arc
component BadTwice { port in Integer i, out Integer o;  connect i -> o;  connect i -> o; }
//                                                                                    ~ error ARC0104: port 'o' is connected with 'i' twice; delete one of the connectors

//// Good.arc
component Good {
  port in Integer slow, in Integer fast;

  component Motor left {
    port in Integer power;
  }

  component Motor right;

  connect slow -> left.power;
  connect fast -> right.power;
}

//// GoodFan.arc
component GoodFan { port in Integer i, out Integer o, out Integer p;  connect i -> o, p; }
