//// Bad.arc
component Bad {
  port in Integer level, <<total>> out Integer seen;

  component Control {
    port <<total>> in Integer level, in Integer speed, out Integer seen;
  }
  component Control ctrl, alone;
//                        ~~~~~ warning ARC0109: output 'seen' of 'alone' is read by nobody; connect it
//                        ~~~~~ error ARC0326: total input 'level' of 'alone' has no sender; connect it with a total one

  connect level -> ctrl.level, ctrl.speed, alone.speed;
//                 ~~~~~~~~~~ error ARC0326: 'ctrl.level' is total, but its sender 'level' may be silent; make the sender <<total>>, or the receiver not
  connect ctrl.seen -> seen;
//                     ~~~~ error ARC0326: 'seen' is total, but its sender 'ctrl.seen' may be silent; make the sender <<total>>, or the receiver not
}

//// Good.arc
component Good {
  port <<total>> in Integer level, <<total>> out Integer seen;

  component Control ctrl {
    port <<total>> in Integer level, in Integer speed, <<total>> out Integer seen;
  }

  connect level -> ctrl.level, ctrl.speed;
  connect ctrl.seen -> seen;
}
