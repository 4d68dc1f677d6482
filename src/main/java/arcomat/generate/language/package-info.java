/** How a target spells things: the description of its language, its identifiers and literals. */
package arcomat.generate.language;
