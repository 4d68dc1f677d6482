// profile: executable
//// Bad.arc
component Bad {
//        ~~~ error ARC0125: component 'Bad' has no behaviour; add an automaton or a table, decompose it, or mark it <<platform>> if the target brings it
  port in Integer power, out Integer turns;
}

//// Good.arc
component Good {
  port in Integer power, out Integer turns;

  automaton {
    state running;
    initial running;
    running {power == ?} / {turns = power / 2};
  }
}

//// GoodDevice.arc
<<platform, layer = "actuators">> component GoodDevice {
  port in Integer power;
}

//// GoodTable.arc
component GoodTable {
  port in Boolean i, out Boolean o;

  table {
    in i;
    out o;
    | true  | => | false |;
    | false | => | true  |;
  }
}

//// GoodWire.arc
component GoodWire {
  port in Integer i, out Integer o;

  connect i -> o;
}
