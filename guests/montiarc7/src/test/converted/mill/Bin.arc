package mill;

/** Keeps what it gets for a slice. */
component Bin<T>(T first) {
    timing instant;
    port in T i, <<delay = "1">> out T o;
    init {
        o = first;
    }
    <<completion = "ignore">> compute {
        if (i != --) {
            o = i;
        }
    }
}
