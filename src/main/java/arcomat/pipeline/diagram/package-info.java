/**
 * Folders of pictures: which components and automata are drawn, and what is marked in them. Knows
 * nothing of how a picture is written.
 */
package arcomat.pipeline.diagram;
