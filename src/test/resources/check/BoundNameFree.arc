//// Bad.arc
component Bad {
  port in Integer step, in Boolean go[2], out Integer count;

  automaton {
    state s;
    initial s;
    s [forall step in {1, 2}: step > 0] / {count = 1};
//            ~~~~ error ARC0346: 'step' means something here already; give it another name
    s [exists i in {1, 2}: forall i in go: i] / {count = 1};
//                                ~ error ARC0346: 'i' means something here already; give it another name
    s [go[0] == true] / {count = let twice = 2 * step in step};
//                                   ~~~~~ error ARC0346: 'twice' is not used; leave it out
  }
}

//// Good.arc
component Good {
  port in Integer step, in Boolean go[2], out Integer count;

  automaton {
    state s;
    initial s;
    s [forall i in {1, 2}: step > i || go[i - 1]] / {count = 1};
    s [(exists i in go: i) && forall i in {0..1}: !go[i]] / {count = let twice = 2 * step in twice * twice};
  }
}
