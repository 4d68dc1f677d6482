/**
 * What is done with a robot's jar: reading, linking and running it on a simulated brick. Knows
 * nothing of models.
 */
package arcomat.pipeline.brick;
