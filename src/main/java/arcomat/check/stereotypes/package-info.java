/** Laws about stereotypes, layers among them: ARC05. */
package arcomat.check.stereotypes;
