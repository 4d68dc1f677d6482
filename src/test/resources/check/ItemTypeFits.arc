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

//// Constants.arc
component Constants {
  port in char key, in byte level, out byte low, out short middle, out char letter;

  automaton {
    variable byte kept = 'a';
    variable char first = 'a' + 1;
    state running;
    initial running;
    running {key == 97, level == -128} / {low = 100 + 27, middle = 'z', letter = 65535};
    running {key == alt {'a', 65536}} / {low = 100 + 28, middle = -32769, letter = -1};
//                            ~~~~~ error ARC0316: input port 'key' takes char, but '65536' is of type Integer; char holds numbers from 0 to 65535
//                                             ~~~~~~~~ error ARC0316: output port 'low' takes byte, but '100 + 28' is of type Integer; byte holds numbers from -128 to 127
//                                                                ~~~~~~ error ARC0316: output port 'middle' takes short, but '-32769' is of type Integer; short holds numbers from -32768 to 32767
//                                                                                 ~~ error ARC0316: output port 'letter' takes char, but '-1' is of type Integer; char holds numbers from 0 to 65535
    running {key == 'b', level == ?} / {low = level + 1, middle = level, letter = level, kept = 127L};
//                                            ~~~~~~~~~ error ARC0316: output port 'low' takes byte, but 'level + 1' is of type Integer; a value is cut off only where you write (byte)
//                                                                                ~~~~~ error ARC0316: output port 'letter' takes char, but 'level' is of type byte; a value is cut off only where you write (char)
//                                                                                              ~~~~ error ARC0316: variable 'kept' takes byte, but '127L' is of type Long; a value is cut off only where you write (byte)
    running {key == 'c', level == ?} / do { low = (byte) (level + 1); kept++; };
//                                                                    ~~~~~~~ error ARC0316: variable 'kept' takes byte, but 'kept++;' is of type Integer; a value is cut off only where you write (byte)
  }
}
