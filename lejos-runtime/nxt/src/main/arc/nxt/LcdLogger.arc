package nxt;

/**
 * One row of the brick's display, for texts.
 *
 * row: from the top
 */
<<platform, layer = "actuators">> component LcdLogger(Integer[0..7] row) {
    /** Replaces the row; up to 16 characters are seen. */
    port in String text;
}
