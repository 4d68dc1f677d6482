/**
 * What the generated lexer and parser run on, made for reading many files: most of the time of a
 * parser goes into memory that it touches once, so tokens, streams and parse trees are as small as
 * ANTLR's interfaces allow. It knows ANTLR and texts, and none of the languages.
 */
package arcomat.syntax.runtime;
