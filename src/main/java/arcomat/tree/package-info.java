/**
 * What was written: one record per production of the grammars, with its place. Names are
 * unresolved; lists cannot be changed, whoever makes a node sees to that. This room knows neither
 * the parser that builds the tree nor what anything means.
 */
package arcomat.tree;
