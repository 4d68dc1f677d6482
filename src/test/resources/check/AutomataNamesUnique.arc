//// BadGuard.arc
component BadGuard {
  port in Boolean tooClose, out Boolean drive;

  automaton Stops {
    state any;
    initial any / {drive = true};
    any {tooClose == true} / {drive = false};
  }

  automaton Stops {
//          ~~~~~ error ARC0206: component 'BadGuard' has two automata named 'Stops'; rename one
    state any;
    initial any / {drive = true};
    any {tooClose == false} / {drive = true};
  }
}

//// GoodGuard.arc
component GoodGuard {
  port in Boolean tooClose, out Boolean drive;

  automaton Stops {
    state any;
    initial any / {drive = true};
    any {tooClose == true} / {drive = false};
  }

  automaton Drives {
    state any;
    initial any / {drive = true};
    any {tooClose == false} / {drive = true};
  }
}
