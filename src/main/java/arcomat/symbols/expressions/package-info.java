/**
 * The values that expressions name, and the types of expressions at a place. Knows scopes, but not
 * who makes them.
 */
package arcomat.symbols.expressions;
