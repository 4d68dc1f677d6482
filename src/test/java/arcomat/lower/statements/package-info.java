/**
 * What statements mean, in a form that is written to be read: they are done one after the other.
 */
package arcomat.lower.statements;
