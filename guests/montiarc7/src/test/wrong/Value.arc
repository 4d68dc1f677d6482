component Value(Grain first = 5, int second = 5) { port sync in int a; }
