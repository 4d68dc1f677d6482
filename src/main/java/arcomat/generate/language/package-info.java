/** How a target spells things: its description, its templates, its identifiers, its expressions. */
package arcomat.generate.language;
