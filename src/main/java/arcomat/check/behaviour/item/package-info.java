/** Laws about what is read and written on the two sides of a transition or in a row: ARC03. */
package arcomat.check.behaviour.item;
