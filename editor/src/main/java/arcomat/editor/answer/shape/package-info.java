/** The shape of a text: its outline, what folds, what is selected together, what has a colour. */
package arcomat.editor.answer.shape;
