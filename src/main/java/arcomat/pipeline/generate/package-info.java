/**
 * Writes code for a target, and makes jars of it where the target has any. Knows nothing of what
 * runs them.
 */
package arcomat.pipeline.generate;
