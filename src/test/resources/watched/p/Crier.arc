package p;

component Crier {
    timing causalsync;

    port <<total>> in Boolean pressed, out String text;

    <<completion = "ignore">> automaton {
        state quiet;

        initial quiet;

        quiet {pressed == true} / {text = "wall"};
    }
}
