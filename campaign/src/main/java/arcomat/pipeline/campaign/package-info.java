/**
 * Campaigns made: worlds and programs are prepared once, an engine makes the runs, rows are put in
 * order, judged and kept. Who makes a run does not matter: rows are the same, and so is the table.
 */
package arcomat.pipeline.campaign;
