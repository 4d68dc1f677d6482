component Above {
    timing instant;
    port in Integer p, in Integer q, out Boolean o;

    <<completion = "ignore">> automaton {
        state s;
        initial s;

        s [q * 2 > p * 2 || q - p == 1] / {o = true};
    }
}
