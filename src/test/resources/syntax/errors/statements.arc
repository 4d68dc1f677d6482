component Statements {
    port in Integer p, out Integer o;
    automaton {
        state s;
        initial s;
        s / do {
            o = = 3;
            if p > 3 { o = 1; }
            o += 1
            o = 2;
            for (int i = 0; i < 3; i++) { o = 3; }
            if (p > 3) { o = ; } else { o = 4; }
            int t = ;
            o = 5;
        };
        s / do { o = 6 };
        s / do o = 7;
        s / { o = 8 };
    }
}
