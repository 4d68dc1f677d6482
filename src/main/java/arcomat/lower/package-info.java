/**
 * The only staircase from text to meaning: turns symbols without error findings into the model,
 * with concrete types, inherited parts folded in, and every abbreviation of the language written
 * out. It reports nothing and runs nothing, and does not know what checks there are.
 */
package arcomat.lower;
