/**
 * What is on the screen in the languages of guests. These texts are found as they were written,
 * also where their guests find something wrong with them.
 */
package arcomat.editor.foreign;
