/**
 * Models in an editor: the language server. It knows the protocol's library, keeps what is on the
 * screen, and asks the other rooms; nobody but the command that starts it knows this room.
 */
package arcomat.editor;
