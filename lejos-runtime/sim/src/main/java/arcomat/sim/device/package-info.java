/**
 * What is inside and around one brick: sockets, motors, screen, buttons, speaker. The classes of
 * lejos.* are thin doors to it; the controller turns its other side. Knows virtual time, but
 * nothing of jars, scripts or class loaders.
 */
package arcomat.sim.device;
