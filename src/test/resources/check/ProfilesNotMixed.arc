//// Bad.arc
component Bad {
  component Control ctrl {
    timing untimed;
    port in Boolean alert;
  }
  component Timer timer {
//                ~~~~~ error ARC0129: 'timer' is time-synchronous, but 'ctrl' is event-driven; give all parts the same kind of timing
    port out Boolean alert;
  }

  connect timer.alert -> ctrl.alert;
}

//// Good.arc
component Good {
  timing untimed;

  component Control ctrl {
    timing untimed;
    port in Boolean alert;
  }
  component Timer timer {
    timing untimed;
    port out Boolean alert;
  }

  connect timer.alert -> ctrl.alert;
}
