/**
 * The text form of what happens to a brick: time, port, value. Knows the names of ports, buttons
 * and values; carries nothing out.
 */
package arcomat.sim.script;
