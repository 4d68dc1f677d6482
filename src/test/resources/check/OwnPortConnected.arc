//// Bad.arc
component Bad {
  port in Integer speed, in Integer limit, out Boolean alarm;
//                                  ~~~~~ warning ARC0108: input 'limit' leads to no part; connect it
//                                                     ~~~~~ warning ARC0108: output 'alarm' comes from no part; connect it

  component Motor motor {
    port in Integer power;
  }

  connect speed -> motor.power;
}

//// Good.arc
component Good {
  port in Integer speed;
  port <<suppress = "ARC0108: for the next version">> out Boolean alarm;

  component Motor motor {
    port in Integer power;
  }

  connect speed -> motor.power;
}

//// GoodAtom.arc
component GoodAtom {
  port in Integer speed, out Boolean alarm;
}
