/**
 * Findings for people and build servers, and what they are compared with: a baseline. Knows nothing
 * of runs and of proofs.
 */
package arcomat.report.finding;
