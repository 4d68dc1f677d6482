/** Features of components, and who chooses them. */
package arcomat.check.structure.feature;
