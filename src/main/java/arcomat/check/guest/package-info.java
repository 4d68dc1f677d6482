/**
 * Laws that come from outside: they see what the tool's own laws see, and whatever goes wrong in
 * them is a finding that names whose they are. Nothing here is asked where there are no guests.
 */
package arcomat.check.guest;
