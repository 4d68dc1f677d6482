component Call {
  port sync in String a, sync out int b;

  automaton {
    initial state S;
    S -> S [a.isEmpty()] / { b = a.length(); log(a); a.concat(a); };
  }
}
