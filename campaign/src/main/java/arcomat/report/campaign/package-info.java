/**
 * Results of campaigns: text, JSON and pages. Counts nothing: that is done by the campaign's judge.
 */
package arcomat.report.campaign;
