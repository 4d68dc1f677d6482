/**
 * Texts beside models, such as worlds, while somebody writes them: what can be said without making
 * or running anything. What each kind of text says is known where it is read.
 */
package arcomat.pipeline.beside;
