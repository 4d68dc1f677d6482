component Door {
  prot in Boolean a;
  port inn Boolean b, out Integer c;
  conect a -> c;
  componet Foo foo;
  deply component Bar { }
  autoconnect prot;
  timing instnt;
  Prat x y;
  automatn {
    state s;
    initial s;
  }
  automaton {
    sate s, t;
    inital s;
    varaible Integer x = 0;
    s {a == true} / {c = 1};
    stat -> s {a == true} t;
  }
  tabel { in a; out c; | true | => | 1 |; }
  implmentation X { }
}
