//// BadLimit.arc
component BadLimit {
  port in Integer speed, out Integer cmd;

  automaton {
    state running;
    initial running;
    running {speed == true} / {cmd = "slow"};
//                    ~~~~ error ARC0316: input port 'speed' takes Integer, but 'true' is of type Boolean
//                                   ~~~~~~ error ARC0316: output port 'cmd' takes Integer, but '"slow"' is of type String
  }
}

//// GoodLimit.arc
component GoodLimit {
  port in Integer speed, out Integer cmd;

  automaton {
    state running;
    initial running;
    running {speed == 3} / {cmd = 1};
  }
}

//// EachElement.arc
component EachElement {
  port in Integer speed, out Integer cmd;

  automaton {
    state running;
    initial running;
    running {speed == alt {1, false, 3}} / {cmd = ["a"]};
//                            ~~~~~ error ARC0316: input port 'speed' takes Integer, but 'false' is of type Boolean
//                                                 ~~~ error ARC0316: output port 'cmd' takes Integer, but '"a"' is of type String
  }
}

//// Narrowing.arc
component Narrowing {
  port in Double distance, out Integer cmd;

  automaton {
    variable Long last = 0;
    state running;
    initial running;
    running {distance == ?} / {cmd = distance, last = 7};
//                                   ~~~~~~~~ error ARC0316: output port 'cmd' takes Integer, but 'distance' is of type Double
  }
}
