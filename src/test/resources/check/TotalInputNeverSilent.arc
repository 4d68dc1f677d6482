//// BadBrake.arc
component BadBrake {
  port <<total>> in Boolean pressed, in Integer speed, out Boolean light;

  automaton {
    state only;
    initial only;
    only {pressed == --} / {light = false};
//                   ~~ warning ARC0338: 'pressed' is never silent (<<total>>); remove this, or the stereotype
    only [pressed != -- && speed == --] / {light = true};
//        ~~~~~~~~~~~~~ warning ARC0338: 'pressed' is never silent (<<total>>); remove this, or the stereotype
  }
}

//// BadTable.arc
component BadTable {
  port <<total>> in Boolean pressed, in Integer speed, out Boolean light;

  table {
    in pressed, speed;
    out light;
    | true | -- | => | true |;
    | --   | *  | => | --   |;
//    ~~ warning ARC0338: 'pressed' is never silent (<<total>>); remove this, or the stereotype
  }
}

//// GoodBrake.arc
component GoodBrake {
  port <<total>> in Boolean pressed, in Integer speed, out Boolean light;

  automaton {
    state only;
    initial only;
    only {pressed == true, speed == --} / {light = true};
    only [speed != --] {pressed == false} / {light = --};
  }
}
