/**
 * Runs components and stream tests, and records what was sent. Knows nothing of bricks and of
 * proofs.
 */
package arcomat.pipeline.simulate;
