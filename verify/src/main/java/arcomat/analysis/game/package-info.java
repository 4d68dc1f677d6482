/**
 * The safety game between an environment that sends inputs and a system that has to keep several
 * requirements at once: the arena, who wins, the counter strategy of an environment that wins, and
 * the strategy of a system that does, as a controller (Pnueli, Rosner, "On the synthesis of a
 * reactive module", POPL 1989). Knows the search's systems and letters, and nothing of how the
 * outcome is told.
 */
package arcomat.analysis.game;
