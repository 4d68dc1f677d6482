/** Names in open models: what stands under the cursor, where else it is named, and renaming it. */
package arcomat.editor.name;
