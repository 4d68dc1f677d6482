package p;

/** The reflex, as a part of a part. */
component Front {
    timing causalsync;

    port <<total>> in Boolean bumped, out Integer speed, out String doing;

    component Reflex(360) reflex;

    connect bumped -> reflex.pressed;
    connect reflex.speed -> speed;
    connect reflex.doing -> doing;
}
