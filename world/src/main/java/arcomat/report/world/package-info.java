/**
 * Runs of a world: as text, JSON and a page that plays them again. Knows nothing of how robots
 * move.
 */
package arcomat.report.world;
