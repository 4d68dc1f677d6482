//// BadDrive.arc
component BadDrive {
  port <<total>> in Boolean stop, <<total>> in Integer[0..100] light, out Integer speed, out Boolean lamp;

  <<completion = "ignore">> automaton {
    state on, off;
    variable Integer n = 0;
    initial on;
    on {stop == false && light < 40} / {speed = 2};
//      ~~~~~~~~~~~~~~~~~~~~~~~~~~~ error ARC0350: this is read as the message 'false && light < 40' for 'stop'; write a condition in [..], or put the message in parentheses
    on {light < 40} / {speed = 2};
//      ~~~~~~~~~~ error ARC0350: this is read as the message 'light < 40' for 'stop'; write a condition in [..], or put the message in parentheses
    on -> off {light == 40 && stop == false} / {speed = 2};
//             ~~~~~~~~~~~~~~~~~~~~~~~~~~~~ error ARC0350: this is read as the message '40 && stop == false' for 'light'; write a condition in [..]
//                      ~~~~~~~~~~~~~~~~~~~ error ARC0316: input port 'light' takes Integer[0..100], but '40 && stop == false' is of type Boolean
//                      ~~~~~~~~~~~~~~~~~~~ error ARC0330: '&&' needs two Booleans, not Integer and Boolean
    on {stop == false, light > 4 || light == 2} / {speed = 2};
//                     ~~~~~~~~~~~~~~~~~~~~~~~ error ARC0310: this block names input port 'stop' twice, here by the type of the message; keep one of the two
//                     ~~~~~~~~~~~~~~~~~~~~~~~ error ARC0350: this is read as the message 'light > 4 || light == 2' for 'stop'; write a condition in [..], or put the message in parentheses
    on {n < 3} / {speed = 2};
//      ~~~~~ error ARC0350: this is read as the message 'n < 3' for 'stop'; write a condition in [..], or put the message in parentheses
    on {!(light < 3)} / {speed = 2};
//      ~~~~~~~~~~~~ error ARC0350: this is read as the message '!(light < 3)' for 'stop'; write a condition in [..], or put the message in parentheses
    on [n > 1 || stop] {stop == true | light != 3} / {speed = 2};
//                      ~~~~~~~~~~~~~~~~~~~~~~~~~ error ARC0350: this is read as the message 'light != 3' for 'stop'; write a condition in [..], or put the message in parentheses
    on {stop == true} / {speed = 2 && light < 40};
//                       ~~~~~~~~~~~~~~~~~~~~~~~ error ARC0350: this is read as the message '2 && light < 40' for 'speed'; write a condition in [..]
//                               ~~~~~~~~~~~~~~~ error ARC0316: output port 'speed' takes Integer, but '2 && light < 40' is of type Boolean
//                               ~~~~~~~~~~~~~~~ error ARC0330: '&&' needs two Booleans, not Integer and Boolean
    on {stop == true} / {speed = light < 40};
//                       ~~~~~~~~~~~~~~~~~~ error ARC0350: this is read as the message 'light < 40' for 'speed'; write a condition in [..]
//                               ~~~~~~~~~~ error ARC0316: output port 'speed' takes Integer, but 'light < 40' is of type Boolean
    on {stop == (light < 40)} / {lamp = light < 40, speed = 3};
    on {(light < 40)} / {lamp = true && light > 40};
    on [stop == false && light < 40] {light == 3} / {lamp = n < 4};
    off {stop == !stop};
//       ~~~~~~~~~~~~~ warning ARC0337: this compares 'stop' with its own negation, so no message fits; write 'stop == false'
  }
}

//// GoodDrive.arc
component GoodDrive {
  port <<total>> in Boolean stop, <<total>> in Integer[0..100] light, out Integer speed, out Boolean lamp;

  <<completion = "ignore">> automaton {
    state on;
    variable Integer n = 0;
    variable Boolean told = false;
    initial on;
    on {stop == (light < 40)} / {lamp = light < 40, speed = 3};
    on {stop == (light < 40)} / {lamp = true && light > 40};
    on [stop == false && light < 40] {light == 3} / {lamp = n < 4};
    on [n == 1] {stop == told, light == 2 + n} / {speed = light};
  }
}

//// BadDark.arc
component BadDark {
  port <<total>> in Integer[0..100] light, out Integer speed;

  <<completion = "ignore">> automaton {
    state on;
    initial on;
    on {light < 40} / {speed = 2};
//      ~~~~~~~~~~ error ARC0318: no input port or variable takes 'light < 40'; a condition stands in [..]
    on [light > 5 || light > 7] {light == 3, light > 1 || light < 0} / {speed = 2};
//                                           ~~~~~~~~~~~~~~~~~~~~~~ error ARC0318: no input port or variable takes 'light > 1 || light < 0'; a condition stands in [..]
  }
}
