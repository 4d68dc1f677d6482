/**
 * The classes of a robot's jar as they were read: what they name and inherit, and the places of
 * findings about them.
 */
package arcomat.brick.jar;
