/** Laws about automata as a whole, their states and transitions: ARC03. */
package arcomat.check.behaviour.automaton;
