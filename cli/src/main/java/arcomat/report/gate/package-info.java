/**
 * Answers of the gate between two versions: findings, verdicts and campaigns, as text, JSON and
 * cases. Knows nothing of how the versions are compared.
 */
package arcomat.report.gate;
