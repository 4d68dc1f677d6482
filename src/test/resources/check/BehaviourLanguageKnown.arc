//// Bad.arc
component Bad {
  port out Boolean lit;

  blink lamp { on 3, off 2 }
//~~~~~ error ARC0133: no behaviour language is called 'blink'; name the guest that brings it, with --with, or write an automaton or a table
}

//// BadWord.arc
component BadWord {
  port out Boolean lit;

  <<completion = "ignore">> automatn {
//                          ~~~~~~~~ error ARC0133: no behaviour language is called 'automatn'; did you mean 'automaton'?
    state s;
    initial s / {lit = true};
  }
}

//// Good.arc
component Good {
  port out Boolean lit;

  automaton {
    state s;
    initial s / {lit = true};
    s / {lit = true};
  }
}
