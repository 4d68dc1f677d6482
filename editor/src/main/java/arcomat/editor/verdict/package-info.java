/**
 * What is known about promises, tests and automata on the screen: asked in the background, and
 * never shown for other texts than those that were asked about.
 */
package arcomat.editor.verdict;
