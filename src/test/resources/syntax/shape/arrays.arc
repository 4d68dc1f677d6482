component Arrays {
    port in Boolean a[2], in Boolean [ 0b10 ] b, c[1], out Integer[0..9][2] d;
    component Part p[2] [x[0] -> a.b[1]], q;
    var Integer v[2] = 3, w;
    connect p.x -> a, b[0].c, d;

    automaton {
        variable Integer e[1];
        int f[2] = 0;
        state s;
        initial s / do { int g[2] = 1; e[0] += 2; d[1] = g[0]; e[0]++; };
        s {a[0] == true, e[0]++} / {d[0x1] = [1, 2]};
    }

    table {
        in a[0], b;
        out d[1];
        | 1 | 2 | => | 3 |;
    }
}
