/**
 * The devices of the NXT brick, simulated. Names and signatures are those of leJOS NXJ 0.9.1, so
 * that the jar that goes on the brick runs here unchanged. Thin doors to arcomat.sim.device; loaded
 * anew for every brick.
 */
package lejos.nxt;
