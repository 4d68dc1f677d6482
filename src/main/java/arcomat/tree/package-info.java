/**
 * What was written: one record per production of the grammars, with its place. Names are
 * unresolved. This room knows neither the parser that builds the tree nor what anything means.
 */
package arcomat.tree;
