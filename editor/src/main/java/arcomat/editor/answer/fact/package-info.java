/**
 * What is known about a name or a place, told beside the text: on hovering, while typing, in it.
 */
package arcomat.editor.answer.fact;
