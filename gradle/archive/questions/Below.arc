component Below {
    timing instant;
    port in Integer p, in Integer q, out Boolean o;

    <<completion = "ignore">> automaton {
        state s;
        initial s;

        s [p < q] / {o = true};
    }
}
