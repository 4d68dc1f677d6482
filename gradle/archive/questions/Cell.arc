component Cell {
    port in Boolean i, out Boolean o;

    <<completion = "ignore">> automaton {
        state s;
        initial s;

        s {i == true} / {o = true};
    }
}
