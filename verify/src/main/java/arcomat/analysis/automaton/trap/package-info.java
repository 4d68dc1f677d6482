/**
 * Whether an automaton may come to where nothing is sent any more, put to solvers: what has been
 * tried is not enough where configurations have no end. Plans to send show that there is no trap,
 * conditions that no transition breaks that there is one. Knows of the exploration only what it has
 * found out.
 */
package arcomat.analysis.automaton.trap;
