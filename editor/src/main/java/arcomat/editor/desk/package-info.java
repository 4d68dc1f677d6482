/** What is open, and the one thread that works on it. */
package arcomat.editor.desk;
