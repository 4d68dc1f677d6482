/**
 * A world with its robots: their jars are brought, run and recorded, and the replay is written.
 * Knows nothing of how a robot moves.
 */
package arcomat.pipeline.world;
