// profile: executable
//// Bad.arc
component Bad {
  port in Boolean i, out Boolean o;

  automaton Passes {
    state s;
    initial s;
    s {i == true} / {o = true};
  }

  automaton Blocks {
//          ~~~~~~ error ARC0126: component 'Bad' has 3 behaviours; code is made from one: write one that satisfies them all, in a component that refines this one
    state s;
    initial s;
    s {i == false} / {o = false};
  }

  table {
//~~~~~ error ARC0126: component 'Bad' has 3 behaviours; code is made from one: write one that satisfies them all, in a component that refines this one
    in i;
    out o;
    | true  | => | false |;
  }
}

//// Good.arc
component Good {
  port in Boolean i, out Boolean o;

  automaton {
    state s;
    initial s;
    s {i == true} / {o = true};
    s {i == false} / {o = false};
  }
}
