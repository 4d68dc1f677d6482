/**
 * Where names stand, and what each stands for there: the way back from symbols to the text, for
 * whoever shows or renames them. Knows all other steps; none of them knows it.
 */
package arcomat.symbols.occurrences;
