package mill;

/** The mean of the last two; nobody says what there is before the first. */
component Average(byte start) {
    timing instant;
    port in byte value;
    port out Integer mean, <<delay = "1">> out Integer last;
    Integer before = start;
    init {
        last = -1;
    }
    <<completion = "ignore">> compute {
        Integer sum = before + value;
        mean = sum / 2;
        if (value > before) {
            last = value;
        } else {
            last = before;
        }
        before = value;
    }
}
