//// Bad.arc
component Bad {
  port in Integer speed;

  component Motor motor {
    port in Integer power;
  }

  connect speed -> motor.power, speed;
//                              ~~~~~ error ARC0107: port 'speed' is connected to itself; correct one of the ends
}

//// BadLoop.arc
component BadLoop {
  port in Integer speed, out Integer o;

  component Motor motor {
    port in Integer power;
  }

  connect motor.power -> motor.power;
//                       ~~~~~~~~~~~ error ARC0107: port 'motor.power' is connected to itself; correct one of the ends
  connect speed -> o;
}

//// Good.arc
component Good {
  port in Integer speed;

  component Motor motor {
    port in Integer power;
  }

  connect speed -> motor.power;
}
