/**
 * Text to tree and back to canonical text: the parser and the formatter for every kind of file. The
 * only room that knows ANTLR. It knows nothing of what names mean or whether a model is well-formed
 * beyond its grammar.
 */
package arcomat.syntax;
