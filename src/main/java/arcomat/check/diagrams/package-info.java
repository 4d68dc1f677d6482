/** Laws about class diagrams: ARC06. */
package arcomat.check.diagrams;
