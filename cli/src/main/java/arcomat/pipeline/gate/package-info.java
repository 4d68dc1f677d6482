/**
 * Compares the models of two versions and asks for reasons where promises were dropped. Knows
 * nothing of where the versions come from.
 */
package arcomat.pipeline.gate;
