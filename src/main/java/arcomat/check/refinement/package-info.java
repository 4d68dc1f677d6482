/** Laws about what a component refines: ARC04. */
package arcomat.check.refinement;
