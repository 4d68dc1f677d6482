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

//// BadParts.arc
component BadParts {
  port in Integer speed, in Boolean go, in String name;
  port out Integer echo;

  component Motor motor {
    port in Integer power, in Integer limit, out Integer turns, out Integer heat;
  }

  component Gauge gauge {
    port in Integer heat, in Integer turns, out Boolean high;
  }

  component Both both {
    port out Integer x, out Boolean y;
  }

  component Takes takes {
    port in Integer x, in Boolean y;
  }

  component Nothing nothing;
//          ~~~~~~~ error ARC0111: there is no component 'Nothing'; declare or import it

  connect speed -> motor;
//                 ~~~~~ error ARC0103: 'motor' is a part, and several of its ports fit 'speed': 'motor.power', 'motor.limit'; write the one that is meant
  connect name -> motor;
//                ~~~~~ error ARC0103: 'motor' is a part, and none of its ports fits 'name'; connect one that does
  connect motor -> echo;
//        ~~~~~ error ARC0103: 'motor' is a part, and several of its ports fit 'echo': 'motor.turns', 'motor.heat'; write the one that is meant
  connect motor -> gauge;
//        ~~~~~ error ARC0103: 'motor' and 'gauge' are parts, and several of their ports fit: 'motor.turns -> gauge.heat', 'motor.turns -> gauge.turns', 'motor.heat -> gauge.heat', 'motor.heat -> gauge.turns'; write which are meant
  connect gauge -> both;
//        ~~~~~ error ARC0103: no output of 'gauge' fits an input of 'both', so none can be connected; write ports that fit
  connect both -> takes.x, takes.y;
//        ~~~~ error ARC0103: 'both' is a part, and its targets ask for different ports of it; write a connector for each
  connect spead -> nothing;
//        ~~~~~ error ARC0103: component 'BadParts' has no port 'spead'; did you mean 'speed'?
  connect speed -> nothing, motor.power;
}

//// GoodParts.arc
component GoodParts {
  port in Integer speed, in Boolean go;
  port out Integer turns, out Boolean high;

  component Motor motor {
    port in Integer speed, in Integer limit, in Boolean start, out Integer turns, out Integer heat;
  }

  component Gauge gauge {
    port in Integer heat, out Boolean tooHigh;
  }

  autoinstantiate off;

  component Copy {
    port in Integer first, out Integer second;
  }

  component Copy copy [second -> motor.limit];

  connect speed -> motor, copy;
  connect go -> motor;
  connect motor -> turns;
  connect motor -> gauge;
  connect gauge -> high;
}
