/** Laws about names: ARC02. */
package arcomat.check.naming;
