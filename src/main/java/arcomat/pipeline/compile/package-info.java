/**
 * Compiles generated Java in memory, loads it, and runs it as the interpreter runs models. Knows
 * nothing of paths and of bricks.
 */
package arcomat.pipeline.compile;
