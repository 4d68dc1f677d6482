/**
 * Behaviours in other languages than automata: what a language says that one means becomes an
 * automaton with the places that it comes from. The tool's own languages are asked here, as those
 * of guests are by {@code pipeline.guest}, which keeps what goes wrong there from everybody else.
 */
package arcomat.translate;
