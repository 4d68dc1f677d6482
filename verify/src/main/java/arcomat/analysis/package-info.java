/**
 * Questions about what models promise: does one component refine another, is a requirement set free
 * of contradictions, what is unhandled, unreachable or left open. Pure functions over the model
 * with verdicts as results. Knows nothing of text, files, processes and clocks.
 */
package arcomat.analysis;
