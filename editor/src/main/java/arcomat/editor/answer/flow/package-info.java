/** Where messages go: what is connected with what, and what is a part of what. */
package arcomat.editor.answer.flow;
