package p;

/** Whatever is met has a name. */
component Names {
    timing causalsync;

    port in Boolean pressed, out String text;

    <<completion = "output">> automaton stops {
        state any;

        initial any / {text = --};

        any {pressed == true} / {text = "wall"};
    }

    <<completion = "output", violated = "continue">> automaton tells {
        state any;

        initial any / {text = --};

        any {pressed == true} / {text = "wall"};
    }
}
