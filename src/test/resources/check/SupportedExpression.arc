//// BadGreeter.arc
component BadGreeter {
  port in String name, out Integer length;

  automaton {
    state greeting;
    initial greeting;
    greeting {name == ?} / {length = name.length()};
//                                   ~~~~~~~~~~~~~ error ARC0319: models call no methods ('length'); compute the value in a <<platform>> component and send it over a port
  }
}

//// GoodGreeter.arc
component GoodGreeter {
  port in String name, out Integer length;

  automaton {
    state greeting;
    initial greeting;
    greeting {name == "Ada"} / {length = 3};
    greeting [name != "Ada"] {name == ?} / {length = 0};
  }
}

//// Equals.arc
component Equals {
  port in String name, out Boolean known;

  automaton {
    state greeting;
    initial greeting;
    greeting [name.equals("Ada")] {name == ?} / {known = true};
//            ~~~~~~~~~~~~~~~~~~ error ARC0319: models call no methods; compare with '==' instead of 'equals'
  }
}

//// Creates.arc
component Creates {
  port in Boolean i, out String o;

  automaton {
    state creating;
    initial creating;
    creating {i == true} / {o = new String("a")};
//                              ~~~~~~~~~~~~~~~ error ARC0319: 'new String("a")' makes an object, and models make none; have a <<platform>> component make it and send it over a port
  }
}

//// Looks.arc
import java.util.List;

component Looks {
  port in List<String> names, out Boolean many, out List<String> first;

  automaton {
    state only;
    initial only;
    only [names.size() > 1] / {many = true};
//        ~~~~~~~~~~~~ error ARC0319: nobody looks into a message of type List<String>, so 'size' cannot be called; compute the value in a <<platform>> component and send it over a port
    only [names.equals(names)] / {first = names};
//        ~~~~~~~~~~~~~~~~~~~ error ARC0319: models call no methods; compare with '==' instead of 'equals'
  }
}
