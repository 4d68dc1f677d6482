//// Bad.arc
component Bad {
  port in Boolean blocked, in Boolean bumped, out Boolean drive;

  <<completion = "ignore">> automaton {
    state stopped, moving;
    initial stopped;
    stopped -> moving [!blocked] / {drive = true};
//                     ~~~~~~~~ warning ARC1010: '!blocked' never holds while blocked is silent, and in stopped no other transition fits then: nothing happens (completion ignore); write '(blocked == -- || !blocked)' if silence counts as well, else handle 'blocked == --'
    moving -> stopped [bumped != false] {blocked == --} / {drive = false};
//                     ~~~~~~~~~~~~~~~ warning ARC1010: 'bumped != false' never holds while bumped is silent, and in moving no other transition fits then: nothing happens (completion ignore); write '(bumped == -- || bumped != false)' if silence counts as well, else handle 'bumped == --'
  }
}

//// BadEvents.arc
/** Nobody rings before it was night once. */
component BadEvents {
  timing untimed;
  port in Boolean press, in Boolean knock, <<state>> in Boolean night, out Boolean ring;

  <<completion = "ignore">> automaton {
    state waiting;
    initial waiting;
    waiting [!night] {press == true} / {ring = true};
//           ~~~~~~ warning ARC1010: '!night' never holds while night has had no message yet, and in waiting no other transition fits then: nothing happens (completion ignore); write '(night == -- || !night)' if silence counts as well, else handle 'night == --'
    waiting {knock == ?} / {ring = false};
  }
}

//// BadForbidden.arc
/** Silence ends the run, or all promises. */
component BadForbidden {
  port in Boolean blocked, out Boolean drive;

  <<completion = "error">> automaton first {
    state only;
//        ~~~~ error ARC1002: in only no transition handles {blocked = true}: that is forbidden (completion error), but this input can come
    initial only;
    only [!(blocked == true)] / {drive = true};
//        ~~~~~~~~~~~~~~~~~~ warning ARC1010: '!(blocked == true)' never holds while blocked is silent, and in only no other transition fits then: that is forbidden (completion error); write '(blocked == -- || !(blocked == true))' if silence counts as well, else handle 'blocked == --'
  }

  automaton second {
    state only;
//        ~~~~ warning ARC1002: in only no transition handles {blocked = true}: anything may happen from then on (completion chaos)
//        ~~~~ warning ARC1006: one slice without a message, and nothing is promised any more: silence is not handled in only (completion chaos)
    initial only;
    only [true != blocked] / {drive = true};
//        ~~~~~~~~~~~~~~~ warning ARC1010: 'true != blocked' never holds while blocked is silent, and in only no other transition fits then: anything may happen from then on (completion chaos); write '(blocked == -- || true != blocked)' if silence counts as well, else handle 'blocked == --'
  }
}

//// BadLater.arc
/** Without bounds: only where the sum is beyond 50, and so by the solver. */
component BadLater {
  port in Integer more, in Boolean stop, out Integer sum;

  <<completion = "ignore">> automaton {
    state adding;
    variable Integer total = 0;
    initial adding;
    adding [more > 0 && more <= 20 && total <= 50] / {total = total + more};
    adding [!stop && total > 50 && total < 90] / {sum = total};
//          ~~~~~ warning ARC1010: '!stop' never holds while stop is silent, and in adding no other transition fits then: nothing happens (completion ignore); write '(stop == -- || !stop)' if silence counts as well, else handle 'stop == --'
  }
}

//// GoodHandled.arc
/** Silence has its own transition, or is in the guard. */
component GoodHandled {
  port in Boolean blocked, in Boolean bumped, out Boolean drive;

  <<completion = "ignore">> automaton {
    state stopped, moving, turning;
    initial stopped;
    stopped -> moving [!blocked] / {drive = true};
    stopped -> turning {blocked == --};
    moving -> stopped [bumped == -- || bumped != false] / {drive = false};
    turning -> stopped [bumped != false];
//  ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC1001: in turning on {blocked = true, bumped = true} two transitions are enabled, and send the same, but lead to different configurations: stopped or moving
    turning -> moving {bumped == ?, blocked == true};
  }
}

//// GoodTotal.arc
/** Is never silent; numbers are another matter, and so is what asks for a message. */
component GoodTotal {
  port <<total>> in Boolean blocked, in Integer[0..9] distance, in Boolean bumped, out Boolean drive;

  <<completion = "ignore">> automaton {
    state stopped, moving, ended;
    initial stopped;
    stopped -> moving [!blocked] / {drive = true};
    moving -> stopped [distance != 3 && !(distance > 7)] / {drive = false};
//  ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC1001: in moving on {blocked = false, distance = 7, bumped = true} two transitions are enabled, and send the same, but lead to different configurations: stopped or ended
    moving -> ended [bumped] / {drive = false};
    ended / {drive = true};
  }
}

//// GoodAnswered.arc
/** Another transition answers whatever comes. */
component GoodAnswered {
  port in Boolean blocked, out Boolean drive;

  <<completion = "ignore">> automaton {
    state stopped, moving;
    initial stopped;
    stopped -> moving / {drive = false};
//  ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC1001: in stopped on {blocked = false} two transitions are enabled, with the same effect: one of them is enough
    stopped -> moving [!blocked] / {drive = false};
    moving -> stopped / {drive = true};
  }
}

//// GoodFirst.arc
/** Holds a value from the beginning. */
component GoodFirst {
  timing untimed;
  port in Boolean press, <<state = "false">> in Boolean night, out Boolean ring;

  <<completion = "ignore">> automaton {
    state waiting;
    initial waiting;
    waiting [!night] {press == true} / {ring = true};
  }
}
