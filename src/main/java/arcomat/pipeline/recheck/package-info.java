/**
 * The check again after a change, of no more than the change touches, with the same findings; and
 * what it leaves for the next one. Knows the files' dependencies, but nothing of what is done with
 * models.
 */
package arcomat.pipeline.recheck;
