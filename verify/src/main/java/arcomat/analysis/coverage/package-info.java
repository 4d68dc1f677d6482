/**
 * Stream tests that take every transition of a component, and whether they would notice if one were
 * missing. Knows no text of tests: that is written elsewhere.
 */
package arcomat.analysis.coverage;
