/**
 * What could be written at a place: what the grammar lets stand there, filled with names that are
 * known.
 */
package arcomat.editor.answer.completion;
