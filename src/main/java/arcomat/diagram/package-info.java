/**
 * Draws models: components with their parts, automata, types. What is to be drawn is a {@link
 * arcomat.diagram.Graph}; a layout makes a {@link arcomat.diagram.Picture} of it, in which
 * everything has its place, and the picture becomes text. All of it is pure and deterministic. The
 * room knows nothing of files and of the texts that models are written in; the widths of letters
 * come from a table, not from the machine's fonts.
 */
package arcomat.diagram;
