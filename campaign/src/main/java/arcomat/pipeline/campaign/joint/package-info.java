/**
 * Requirements on what several robots do, watched while a world runs: what ports of their programs
 * show, and what can be read in the world, is put before generated monitors at each step. Needs no
 * models: monitors travel as classes.
 */
package arcomat.pipeline.campaign.joint;
