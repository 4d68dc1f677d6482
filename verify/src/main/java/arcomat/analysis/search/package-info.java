/**
 * What all searches share: a budget with the shortcuts that may be taken, moments of a trace,
 * numbers for configurations and for macro states, and what an opponent can enforce. Knows no
 * question.
 */
package arcomat.analysis.search;
