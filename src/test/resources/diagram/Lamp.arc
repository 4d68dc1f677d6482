component Lamp {
    port in Boolean button, out Boolean light;

    automaton {
        state dark, bright;

        initial dark / {light = false};

        dark -> bright {button == true} / {light = true};
        bright -> dark {button == true} / {light = false};
        bright {button == false};
    }
}
