//// Bad.arc
component Bad {
  port in Integer speed;
  port out Integer echo;

  component Motor motor {
    port in Integer power, out Integer turns;
  }

  component Gauge {
    port out Integer level;
  }

  component Motor spare [turns -> echoo; tuns -> echo];
//                                ~~~~~ error ARC0103: component 'Bad' has no port 'echoo'; did you mean 'echo'?
//                                       ~~~~ error ARC0103: 'spare' of type 'Motor' has no port 'tuns'; did you mean 'turns'?

  connect speed -> motor.pover, moter.power;
//                       ~~~~~ error ARC0103: 'motor' of type 'Motor' has no port 'pover'; did you mean 'power'?
//                              ~~~~~ error ARC0103: component 'Bad' has no part 'moter'; did you mean 'motor'?
  connect sped -> Motor.power;
//        ~~~~ error ARC0103: component 'Bad' has no port 'sped'; did you mean 'speed'?
//                ~~~~~ error ARC0103: component 'Bad' has no part 'Motor'; did you mean 'motor'?
  connect level -> motor.power;
//        ~~~~~ error ARC0103: component 'Bad' has no port 'level'; did you mean 'gauge.level'?
}

//// Good.arc
component Good {
  port in Integer speed;
  port out Integer echo;

  component Motor motor {
    port in Integer power, out Integer turns;
  }

  connect speed -> motor.power;
  connect motor.turns -> echo;
}
