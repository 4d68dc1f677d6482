/** Laws about I/O tables: ARC03. */
package arcomat.check.behaviour.table;
