/**
 * A system that wins a game, as a Mealy machine, and as an automaton that people can read. Knows
 * nothing of games.
 */
package arcomat.analysis.game.controller;
