/**
 * The game between an environment that sends inputs and a system that has to keep several
 * requirements at once: positions, who wins, how the environment wins, and what a system that wins
 * does. Knows the engine's sides and letters, and nothing of how the outcome is told.
 */
package arcomat.analysis.game;
