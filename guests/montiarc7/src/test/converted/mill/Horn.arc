package mill;

/** A horn, with a pipe or two. */
component Horn {
    timing instant;
    feature low, high;
    port in Integer i, out Integer o;
    constraint (low || high);
    varif (low && high) {
        <<completion = "ignore">> compute {
            o = 2 * i;
        }
    } else {
        <<completion = "ignore">> compute {
            if (i != --) {
                o = i;
            }
        }
    }
}
