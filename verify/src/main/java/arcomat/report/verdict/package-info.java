/**
 * Answers to questions about automata, with the runs that prove them wrong. Knows nothing of how an
 * answer is found.
 */
package arcomat.report.verdict;
