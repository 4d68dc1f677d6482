/**
 * What leJOS' devices have in common: the interfaces that the simulated devices implement. Names
 * and signatures are those of the brick; nothing here knows the simulation.
 */
package lejos.robotics;
