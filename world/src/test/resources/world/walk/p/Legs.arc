package p;

component Legs {
    timing instant;
    port <<total>> in Integer[0..100] light, out Integer speed;

    <<completion = "ignore">> automaton {
        state walking;
        initial walking;
        walking -> walking [light % 2 == 0] / {speed = 360};
        walking -> walking [light % 2 == 1] / {speed = -360};
    }
}
