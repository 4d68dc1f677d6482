package mill;

/** What no feature decides is chosen when it is converted. */
component Settled {
    timing instant;
    feature fast;
    port in Integer a, out Integer b;
    varif (fast) {
        <<completion = "ignore">> compute {
            b = 2;
        }
    } else {
        <<completion = "ignore">> compute {
            if (a != --) {
                b = a;
            }
        }
    }
}
