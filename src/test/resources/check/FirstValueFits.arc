//// Bad.cd
classdiagram Bad {
  enum Key { up, down; }
}

//// BadMessages.arc
import Bad.*;

component BadMessages {
  timing untimed;
  port in Boolean ask, out Boolean answer;
  port <<state = "left">> in Key key;
//               ~~~~~~ error ARC0340: port 'key' carries Key, and 'left' is no message of that type
  port <<state = 7>> in Integer[0..5] level, <<state = "x">> in Boolean quiet, <<state = "1.">> in Double heat;
//               ~ error ARC0340: port 'level' carries Integer[0..5], and '7' is no message of that type
//                                                     ~~~ error ARC0340: port 'quiet' carries Boolean, and 'x' is no message of that type
//                                                                                       ~~~~ error ARC0340: port 'heat' carries Double, and '1.' is no message of that type
  port <<state = "3000000000">> in Integer count, <<state = "no">> in Character mark;
//               ~~~~~~~~~~~~ error ARC0340: port 'count' carries Integer, and '3000000000' is no message of that type
//                                                          ~~~~ error ARC0340: port 'mark' carries char, and 'no' is no message of that type

  automaton {
    state only;
    initial only;
    only [quiet] {ask == true, key == up, level == 1} / {answer = true};
    only [heat > 1.0 && count > 1 && mark == 'x'] {ask == false} / {answer = true};
  }
}

//// BadOutput.arc
component BadOutput {
  timing untimed;
  port in Boolean ask, <<state = true>> out Boolean answer;
//                               ~~~~ error ARC0340: port 'answer' holds nothing itself: only inputs of untimed components without parts do; write the value where it is held

  automaton {
    state only;
    initial only;
    only {ask == true} / {answer = true};
  }
}

//// BadSlices.arc
component BadSlices {
  port <<state = true>> in Boolean ask, out Boolean answer;
//               ~~~~ error ARC0340: port 'ask' holds nothing itself: only inputs of untimed components without parts do; write the value where it is held

  automaton {
    state only;
    initial only;
    only {ask == true} / {answer = true};
  }
}

//// BadWhole.arc
component BadWhole {
  timing untimed;
  port in Boolean ask, <<state = true>> in Boolean quiet, out Boolean answer;
//                               ~~~~ error ARC0340: port 'quiet' holds nothing itself: only inputs of untimed components without parts do; write the value where it is held
  component Part part;
  connect ask -> part.ask;
  connect quiet -> part.quiet;
  connect part.answer -> answer;
}

//// Part.arc
component Part {
  timing untimed;
  port in Boolean ask, <<state = true>> in Boolean quiet, out Boolean answer;

  automaton {
    state only;
    initial only;
    only [quiet] {ask == true} / {answer = true};
  }
}

//// Good.arc
import Bad.*;

component Good {
  timing untimed;
  port in Boolean ask, <<state = true>> in Boolean quiet, out Boolean answer;
  port <<state = up>> in Key key, <<state = "down">> in Key other, <<state>> in Key unknown;
  port <<state = "-3">> in Integer low, <<state = 5>> in Integer[0..5] level, <<state = "-1.5">> in Double heat;
  port <<state = "">> in String word, <<state = "x">> in Character mark;

  automaton {
    state only;
    initial only;
    only [quiet && low < level && heat < 0.0] {ask == true, key == up, other == down} / {answer = true};
    only [word == "" && mark == 'x' && unknown == --] {ask == false} / {answer = true};
  }
}
