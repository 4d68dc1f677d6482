/** Laws about expressions and ranges: ARC03. */
package arcomat.check.behaviour.expression;
