/** Laws about ports that are never silent: ARC03. */
package arcomat.check.behaviour.total;
