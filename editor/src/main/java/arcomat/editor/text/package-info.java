/** Positions and edits, between the tool's words for them and the protocol's. */
package arcomat.editor.text;
