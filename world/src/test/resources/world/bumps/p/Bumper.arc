package p;

/** Says when the bumper is pressed, and when it is free again. */
<<platform, layer = "sensors">> component Bumper {
    timing untimed;

    port out Boolean pressed;
}
