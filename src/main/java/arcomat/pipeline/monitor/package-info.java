/**
 * Monitors of requirements: as generated files, at the ports of a simulation, and in programs.
 * Knows nothing of how these run.
 */
package arcomat.pipeline.monitor;
