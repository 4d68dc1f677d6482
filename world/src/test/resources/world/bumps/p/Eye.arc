package p;

/** Says how far it sees, whenever that changes. */
<<platform, layer = "sensors">> component Eye {
    timing untimed;

    port out Integer[0..255] distance;
}
