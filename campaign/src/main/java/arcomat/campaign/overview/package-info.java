/**
 * What the rows of a campaign look like as a whole: how often which number, where which values go
 * wrong. Counts only: a million rows take it no more memory than a thousand.
 */
package arcomat.campaign.overview;
