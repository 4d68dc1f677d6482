component Any {
    port in Boolean i, out Boolean o;

    <<completion = "output">> automaton {
        state s;
        initial s;
    }
}
