//// Bad.arc
component Bad {
  port in Integer speed, out Integer seen;

  component Motor motor {
    port in Integer power, out Integer turns;
  }

  connect motor.power -> speed;
//        ~~~~~~~~~~~~~~~~~~~~ error ARC0105: this connector leads from the receiver 'motor.power' to the sender 'speed'; turn it round
  connect seen -> motor.turns;
//        ~~~~~~~~~~~~~~~~~~~ error ARC0105: this connector leads from the receiver 'seen' to the sender 'motor.turns'; turn it round
}

//// Good.arc
component Good {
  port in Integer speed, out Integer seen;

  component Motor motor {
    port in Integer power, out Integer turns;
  }

  connect speed -> motor.power;
  connect motor.turns -> seen;
}
