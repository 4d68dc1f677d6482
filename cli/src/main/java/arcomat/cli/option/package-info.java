/** Options that several commands share, and the forms of results that they name. */
package arcomat.cli.option;
