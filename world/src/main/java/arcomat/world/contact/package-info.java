/**
 * What bodies that touch do to each other's speeds within one step of time: impulses, as in
 * Moreau's time stepping (Moreau, <i>Unilateral contact and dry friction in finite freedom
 * dynamics</i>, 1988), found by going through the contacts again and again. It knows speeds and
 * directions, and no world. Lengths are in mm, masses in grams, times in seconds.
 */
package arcomat.world.contact;
