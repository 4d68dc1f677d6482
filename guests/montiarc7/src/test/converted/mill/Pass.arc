package mill;

component Pass<T> {
    timing instant;
    port in T i;
    port out T o;
    <<completion = "ignore">> compute {
        if (i != --) {
            o = i;
        }
    }
}
