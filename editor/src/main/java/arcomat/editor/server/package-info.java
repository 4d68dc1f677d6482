/** The protocol: what can be asked, and by which name. */
package arcomat.editor.server;
