/** Statements in the form in which they are carried out one after the other. */
package arcomat.semantics.statement;
