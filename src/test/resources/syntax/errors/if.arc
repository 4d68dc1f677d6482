component If {
    port in Boolean wall, out Boolean b;

    automaton {
        state s;
        initial s;
        if (wall) b = true;
        in (wall) {b == true};
        s -> s if (wall) / {b = true};
    }
}
