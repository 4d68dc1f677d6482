//// Bad.arc
component Bad {
  component Control ctrl {
    timing instant;
    port in Boolean alert, out Boolean start;
  }
  component Timer timer {
    timing instant;
    port in Boolean start, out Boolean alert;
  }

  connect ctrl.start -> timer.start;
//                      ~~~~~~~~~~~ error ARC0124: messages run in a circle without delay: ctrl -> timer -> ctrl; let one of these parts react a slice later
  connect timer.alert -> ctrl.alert;
}

//// BadSelf.arc
component BadSelf {
  component Control ctrl {
    timing instant;
    port in Boolean alert, out Boolean start;
  }

  connect ctrl.start -> ctrl.alert;
//                      ~~~~~~~~~~ error ARC0124: messages run in a circle without delay: ctrl -> ctrl; let one of these parts react a slice later
}

//// BadDeep.arc
component BadDeep {
  component Inner inner {
    port in Boolean i, out Boolean o;
    component Gate gate {
      port in Boolean i, <<delay = "0">> out Boolean o;
    }
    connect i -> gate.i;
    connect gate.o -> o;
  }
  component Gate gate {
    port in Boolean i;
    port <<delay = "0">> out Boolean o;
  }

  connect inner.o -> gate.i;
//                   ~~~~~~ error ARC0124: messages run in a circle without delay: inner -> gate -> inner; let one of these parts react a slice later
  connect gate.o -> inner.i;
}

//// Good.arc
component Good {
  component Control ctrl {
    timing instant;
    port in Boolean alert, out Boolean start;
  }
  component Timer timer {
    timing delayed;
    port in Boolean start, out Boolean alert;
  }

  connect ctrl.start -> timer.start;
  connect timer.alert -> ctrl.alert;
}

//// GoodParallel.arc
component GoodParallel {
  port in Boolean i, out Boolean o;
  component Two two {
    timing instant;
    port in Boolean a, in Boolean b, out Boolean c, out Boolean d;
    component Gate ab {
      timing instant;
      port in Boolean i, out Boolean o;
    }
    component Gate cd;
    connect a -> ab.i;
    connect ab.o -> c;
    connect b -> cd.i;
    connect cd.o -> d;
  }

  connect i -> two.a;
  connect two.c -> two.b;
  connect two.d -> o;
}

//// GoodEvents.arc
component GoodEvents {
  component Control ctrl {
    timing untimed;
    port in Boolean alert, out Boolean start;
  }
  component Timer timer {
    timing untimed;
    port in Boolean start, out Boolean alert;
  }

  connect ctrl.start -> timer.start;
  connect timer.alert -> ctrl.alert;
}
