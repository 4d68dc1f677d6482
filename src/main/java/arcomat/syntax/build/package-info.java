/**
 * From ANTLR's parse trees to the records of {@code arcomat.tree}: one small visitor for each
 * family of nodes. Builders see well-formed parse trees only.
 */
package arcomat.syntax.build;
