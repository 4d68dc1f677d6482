package mill;

/** What it does is said elsewhere: the speed follows at once, the heat a slice later. */
component Shaft {
    timing instant;
    port in Integer power, out Integer speed, <<delay = "1">> out Integer heat;
}
