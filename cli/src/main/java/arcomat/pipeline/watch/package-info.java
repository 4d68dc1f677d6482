/**
 * Models while somebody works on them: what changed, what has to be asked again, and what is broken
 * now. Knows nothing of how that is shown.
 */
package arcomat.pipeline.watch;
