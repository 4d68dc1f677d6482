/**
 * What all results are written with: tables, source lines, JSON, XML and CSV, and letters that
 * anybody can see. Knows nothing of results.
 */
package arcomat.report.text;
