/**
 * Devices on a bus of two wires, as the brick's sockets have it: how one is described, by this
 * project or by a team for a sensor of its own, and those that leJOS has classes for. Knows nothing
 * of bricks.
 */
package arcomat.sim.bus;
