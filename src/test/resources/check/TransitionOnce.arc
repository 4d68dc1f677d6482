//// BadDoor.arc
component BadDoor {
  port in Boolean near, in Integer n, out Boolean open, out Boolean lit;

  automaton {
    state shut, wide;
    initial shut;
    shut -> wide [n > 3] {near == true} / {open = true, lit = true};
    shut->wide [n  > 3] {near == true} / {lit = true, open = true};
//  ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC0349: this transition is written above already; correct one of them, or delete this one
    wide {n == 1};
    wide -> wide {n == 1};
//  ~~~~~~~~~~~~~~~~~~~~~~ warning ARC0349
  }
}

//// GoodDoor.arc
component GoodDoor {
  port in Boolean near, in Integer n, out Boolean open;

  automaton {
    state shut, wide;
    initial shut;
    shut -> wide {near == true} / {open = true};
    shut -> wide {near == true, n == 1} / {open = true};
    shut -> wide [n > 3] {near == true} / {open = true};
    wide -> shut {near == true} / {open = true};
  }
}
