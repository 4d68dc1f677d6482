package mill;

component Sorter {
  port sync in String kind, sync in int size;
  port sync out int box;

  int moved = 0;

  automaton {
    initial state Working {
      initial state Small;
      state Large;

      // Stays in the state around, and begins in it anew.
      -> [size == 0] / { moved = 0; box = moved; }

      Small -> Large [size > 10] / {
        moved++;
        switch (kind) {
          case "wood":
          case "cork": { box = 1; break; }
          case "iron": box = 2;
          default: box = 3 + moved;
        }
      }
      Large -> Large [size > 10] / { box = 7; }
    }
  }
}
