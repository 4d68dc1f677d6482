package p;

component Sum {
    port in Integer i, out Integer o;

    init Begin { n = 1; }
    <<completion = "ignore">> compute Sum { Integer k = i; if (k > 2) { n += k; } else o = n; }
}
