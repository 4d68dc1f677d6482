/**
 * Runs of models and stream tests: as tables, CSV, JSON and pages to step through. Knows nothing of
 * how a run came about.
 */
package arcomat.report.run;
