package arcomat.syntax.layout;

/**
 * A token or a comment in a line.
 *
 * @param space whether a space stands before it
 * @param breakLevel how deep a line may be broken before it, 0 for the best place; -1 for never
 * @param breakBefore whether a new line must begin with it
 * @param column whether it is a bar between the cells of a table
 */
record Piece(String text, boolean space, int breakLevel, boolean breakBefore, boolean column) {}
