//// Bad.arc
component Bad {
  port in Integer level, out Integer shown;
  java inv code: { return true; };
//         ~~~~ warning ARC0132: invariant 'code' is not looked at by any command: it is written in 'java'
  ocl inv sets: forall x in level: x > 0;
//        ~~~~ warning ARC0132: invariant 'sets' is not looked at by any command: there is no array and no type 'level'
  ocl inv typo: shwon > 0;
//        ~~~~ warning ARC0132: invariant 'typo' is not looked at by any command: 'shwon' is not a port, a variable or a parameter; did you mean 'shown'?
  ocl inv number: level + shown;
//        ~~~~~~ warning ARC0132: invariant 'number' is not looked at by any command: it has type Integer, not Boolean
  inv called: shown.max(level) > 0;
//    ~~~~~~ warning ARC0132: invariant 'called' is not looked at by any command: models call no methods ('max'); compute the value in a <<platform>> component and send it over a port
}

//// Several.arc
component Several {
  port in Boolean level;
  inv one: n > 0;
//    ~~~ warning ARC0132: invariant 'one' is not looked at by any command: several automata have a variable 'n'
  inv other: m > 0;

  automaton first {
    state a;
    variable Integer[0..1] n = 0, m = 0;
    initial a;
  }

  automaton second {
    state a;
    variable Integer[0..1] n = 0;
    initial a;
  }
}

//// Events.arc
component Events {
  timing untimed;
  port in Integer level;
  ocl inv positive: level > 0;
//        ~~~~~~~~ warning ARC0132: invariant 'positive' is not looked at by any command: it is a law about slices, and the component handles events
}

//// Sensor.arc
<<platform, layer = "sensors">> component Sensor {
  port out Integer level;
  ocl inv positive: level > 0;
//        ~~~~~~~~ warning ARC0132: invariant 'positive' is not looked at by any command: a platform component has no behaviour in the model
}

//// Parts.arc
component Parts {
  port in Integer level;
  ocl inv inside: right.shown == -- || right.shown > 0;
  ocl inv input: right.level > 0;
//        ~~~~~ warning ARC0132: invariant 'input' is not looked at by any command: 'right.level' is neither a constant of a known enum nor an attribute of a value
  component GoodSender right;
//                     ~~~~~ warning ARC0109
  connect level -> right.level;
}

//// GoodSender.arc
component GoodSender {
  port in Integer level, out Integer shown;
  ocl inv positive: shown == -- || shown > limit;
  ocl inv counted: count >= 0 && shown != -- implies level > 0 <=> count > 0;
  Integer limit = 0;

  automaton {
    state always;
    Integer count = 0;
    initial always;
    always [level > 0] / {shown = level, count = 1};
  }
}

//// GoodHeir.arc
component GoodHeir extends GoodSender {
  ocl inv less: shown == -- || shown < 100 + count;
}
