package nxt;

/**
 * One row of the brick's display, for a number behind a label: a sensor's value, say.
 *
 * row: from the top
 * label: at the left of the row; a long number covers its end
 */
<<platform, layer = "actuators">> component LcdNumber(Integer[0..7] row, String label = "") {
    /** Replaces the last number. */
    port in Integer number;
}
