/**
 * Symbolic alphabets: letters that look alike to all that read them are one (the minterms of
 * D'Antoni, Veanes, "Minimization of symbolic automata", POPL 2014); here is who looks, and what
 * stands for what nobody names.
 */
package arcomat.analysis.search.letter;
