/**
 * Results for people and machines: findings with their source lines, traces and test results as
 * text, CSV and JSON. Pure functions from results to text; knows neither how results come about nor
 * where the text goes.
 */
package arcomat.report;
