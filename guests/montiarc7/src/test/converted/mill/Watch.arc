package mill;

/** Says how often the mill ran too fast, and what it has to say goes to a terminal, too. */
component Watch {
    timing instant;
    port in Integer speed, out Boolean alarm;
    Integer turns = 0;
    <<completion = "ignore">> automaton {
        state Calm, Loud;
        initial Calm;
        Calm -> Calm [speed > 9 && turns < 2] / do {
            turns++;
            alarm = false;
        };
        Calm -> Loud [speed > 9 && !(turns < 2)] / do {
            turns++;
            alarm = true;
        };
        Loud -> Calm [speed <= 9] / do {
            turns = 0;
            alarm = false;
        };
    }
}
