/** Laws about stream tests: ARC07. */
package arcomat.check.tests;
