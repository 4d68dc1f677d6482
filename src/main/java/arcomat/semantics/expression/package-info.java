/**
 * What expressions, guards and effects come to, as rt computes it, and what can be said of them
 * without computing: rewritten, simplified, which data they read and where these flow.
 */
package arcomat.semantics.expression;
