/**
 * What all steps share: the names of paths, somebody to tell about progress, the user's wrong use,
 * and a limit on the time of other programs. Knows no step.
 */
package arcomat.pipeline.step;
