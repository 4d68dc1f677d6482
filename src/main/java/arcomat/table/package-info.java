/**
 * I/O tables: a language like those that guests bring, and written against the same door. It knows
 * what a guest may know, and nobody but the list of the tool's own languages knows it.
 */
package arcomat.table;
