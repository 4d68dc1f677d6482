package mill;

/** The mean of the last two; nobody says what there is before the first. */
component Average(Integer[-128..127] start) {
    timing instant;
    port in Integer[-128..127] value;
    port out Integer mean, <<delay = "1">> out Integer last;
    Integer before = start;
    <<completion = "ignore">> automaton {
        state computing;
        initial computing / do {
            last = -1;
        };
        computing -> computing / do {
            Integer sum = before + value;
            mean = sum / 2;
            if (value > before) {
                last = value;
            } else {
                last = before;
            }
            before = value;
        };
    }
}
