/**
 * Monitors of requirements: as generated files, and at the ports of a simulation. Knows nothing of
 * how a simulation runs.
 */
package arcomat.pipeline.monitor;
