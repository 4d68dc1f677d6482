//// Bad.arc
component Bad {
  port in Integer level, out Integer shown;
  ocl inv positive: shown > 0;
//        ~~~~~~~~ warning ARC0132: invariant 'positive' is not looked at by any command; write it as an automaton of a component that this one refines, and 'arcomat verify' proves it
}

//// Positive.arc
component Positive {
  port in Integer level, out Integer shown;

  <<omitted = "free">> automaton {
    state always;
    initial always;
    always [level > 0] / {shown = level};
  }
}

//// Good.arc
component Good refines Positive {
  port in Integer level, out Integer shown;
}
