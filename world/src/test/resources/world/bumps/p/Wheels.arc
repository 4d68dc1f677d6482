package p;

/** Two wheels that turn at one speed. */
<<platform, layer = "actuators">> component Wheels {
    timing untimed;

    port in Integer speed;
}
