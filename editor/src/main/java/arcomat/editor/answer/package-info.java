/** What an editor asks about a model: a class for each question. */
package arcomat.editor.answer;
