package p;

/** Drives to and fro between what it bumps into. */
<<deploy>> component Rover {
    timing untimed;

    component Eye eye;
    component Bumper bumper;
    component Counter counter;
    component Mind mind;
    component Wheels wheels;

    connect bumper.pressed -> mind.pressed, counter.pressed;
    connect eye.distance -> mind.distance;
    connect counter.enough -> mind.enough;
    connect mind.speed -> wheels.speed;
}
