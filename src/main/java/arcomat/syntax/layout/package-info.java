/**
 * Canonical white space. Works on the token stream, so tokens and comments are kept by
 * construction; the parse tree only tells where lines begin, how deep they are and what kind of
 * bracket a bracket is.
 */
package arcomat.syntax.layout;
