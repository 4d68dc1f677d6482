package p;

/** Says in every slice how fast to go. */
component Reflex(Integer cruise) refines Stands {
    timing causalsync;

    port <<total>> in Boolean pressed, <<total>> out Integer speed, <<total>> out String doing;

    automaton {
        state driving;

        initial driving / {speed = cruise, doing = "driving"};

        driving {pressed == true} / {speed = 0, doing = "standing"};
        driving {pressed == false} / {speed = cruise, doing = "driving"};
    }
}
