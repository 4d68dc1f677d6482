package mill;

component Pass<T> {
    timing instant;
    port in T i;
    port out T o;
    <<completion = "ignore">> automaton {
        state computing;
        initial computing;
        computing -> computing / do {
            if (i != --) {
                o = i;
            }
        };
    }
}
