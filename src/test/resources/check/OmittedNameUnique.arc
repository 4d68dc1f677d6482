//// BadGuard.arc
component BadGuard {
  port in Boolean left, in Boolean right, out Integer speed;

  automaton {
    state driving;
    initial driving / {3};
    driving {true} / {0};
//           ~~~~ error ARC0318: 'true' could be meant for 'left', 'right'; write the name before it, as in 'left == true'
  }
}

//// GoodGuard.arc
component GoodGuard {
  port in Boolean left, in Boolean right, out Integer speed;

  automaton {
    state driving;
    initial driving / {3};
    driving {left == true} / {0};
  }
}

//// NoCandidate.arc
component NoCandidate {
  port in Boolean left, out Integer speed;

  automaton {
    state driving;
    initial driving / {"go"};
//                     ~~~~ error ARC0318: no output port or variable takes '"go"'; correct the message, or write the name that is meant before it
    driving {left == true} / {0};
  }
}

//// Typeless.arc
component Typeless {
  port in Boolean left, in Integer right, out Integer speed;

  automaton {
    state driving;
    initial driving;
    driving {--} / {0};
//           ~~ error ARC0318: '--' could be meant for 'left', 'right'; write the name before it, as in 'left == --'
  }
}

//// Itself.arc
component Itself {
  port in Boolean a, in Boolean b, in Integer m, in Integer n, out Integer c, out Integer d;

  automaton {
    state s;
    initial s;
    s {b} / {c = 1};
//     ~ error ARC0318: 'b' could be meant for 'a', 'b'; write the name before it, as in 'b == true'
    s {n} / {c = 1};
//     ~ error ARC0318: 'n' could be meant for 'm', 'n'; write the name before it, as in 'n == ..'
    s {--} / {m};
//     ~~ error ARC0318: '--' could be meant for 'a', 'b', 'm', 'n'; write the name before it, as in 'a == --'
//            ~ error ARC0318: 'm' could be meant for 'c', 'd'; write the name before it, as in 'c = m'
  }
}
