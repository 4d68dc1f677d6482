/**
 * Results for people and machines: findings with their source lines, traces and test results as
 * text, CSV and JSON, runs as pages to step through, all that build servers read as SARIF, JUnit
 * XML and GitHub's commands, and the baselines that findings are compared with. Pure functions from
 * results to text; knows neither how results come about nor where the text goes.
 */
package arcomat.report;
