package mill;

/* Presses what comes, at once or one slice later. */
component Press(Integer most = 5) {
    timing instant;
    feature slow, counting;
    // Counting takes its time.
    constraint (counting implies slow);
    port in Integer weight;
    varif (slow) {
        port <<delay = "1">> out Integer pressed;
        init {
            pressed = 0;
        }
        <<completion = "ignore">> compute {
            if (weight > most) {
                pressed = most;
            } else if (weight != --) {
                pressed = weight;
            }
        }
    } else {
        varif ((counting <=> slow)) {
            port out Integer pressed;
            <<completion = "ignore">> compute {
                if (weight != --) {
                    pressed = weight;
                }
            }
        }
    }
}
