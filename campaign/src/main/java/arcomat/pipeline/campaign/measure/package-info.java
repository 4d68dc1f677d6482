/**
 * Columns that a campaign defines: expressions in the language of the models over what can be read
 * in a world. Each becomes a small component in memory, so that it is checked and has the meaning
 * that it would have in a model, and is asked again at each step of a run. Needs the texts of a
 * campaign and its world, and no files.
 */
package arcomat.pipeline.campaign.measure;
