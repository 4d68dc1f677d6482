/**
 * Bluetooth between bricks, simulated; signatures as on the real one. Thin doors to
 * arcomat.sim.radio.
 */
package lejos.nxt.comm;
