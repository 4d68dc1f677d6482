package p;
component Statements {
    port in Integer p, out Integer o;
    int a = 0; var Integer b;
    automaton {
        initial state s, <<suppress = "ARC0305: x">> t;
        initial {o = 1} state u;
        initial do { o = 2; } s, t;
        initial do {} state v;
        initial s / do { a = 1; b = a; };
        initial;
        initial {a} / {b};
        do -> do / do {};
        do [a == null && null != p] {p = null} / {o = null};
        s -> t [a > 0] {p == ?} / do {
            a = p; b += a; a -= b + 1; a++; b--; o = --; o = null; o = ?; o = [a, b];
            int c = 1, d; var p.q.Type e = E.f; p.q.Type g;
            if (a > b) a = 1;
            if (a > b) { a = 1; } else b = 2;
            if (a > b) { } else if (b > a) { Integer k = a; o = k; } else { { o = 3; } }
            if (a > b) if (c) a = 1; else b = 2;
            do = 1; do++; if (do) { }
        };
    }
}
