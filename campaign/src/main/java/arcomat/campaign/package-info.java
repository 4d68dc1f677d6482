/**
 * Campaigns: many runs of one world, each with values and a seed of its own, and what their answers
 * say all together. What run number n is depends on the campaign's text and on n alone, so that
 * anybody anywhere can do it; what a table of rows proves depends on the rows in the order of their
 * numbers, and not on who came first. Nothing runs here.
 */
package arcomat.campaign;
