/**
 * The control side of simulated bricks: put programs on bricks in a laboratory, let virtual time
 * pass, expose sensors, press buttons, look at motors and screens. Programs and lejos.* never see
 * it.
 */
package arcomat.sim;
