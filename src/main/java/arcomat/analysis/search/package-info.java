/**
 * What all searches share: a budget with the shortcuts that may be taken, moments of a trace, and
 * numbers for configurations and for sets of them. Knows no question.
 */
package arcomat.analysis.search;
