/**
 * What can be said about one automaton alone: every analysis watches one exploration of the
 * configurations that can be reached. Knows meaning, not text: places are only passed on, and no
 * analysis knows another.
 */
package arcomat.analysis.automaton;
